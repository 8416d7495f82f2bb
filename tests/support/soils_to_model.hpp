// Gradings that `suffuse new` is tested with.
#pragma once

#include "tests/support/program.hpp"

namespace suffuse::test {

/// The soils of these tests, as files in their folder.
class SoilsToModel : public Cli {
protected:
    void SetUp() override {
        // A sand without the sizes from 0.3 to 0.8 mm, as a laboratory would write it.
        write_to(folder / "gap.csv", "Sieve (mm);% passing\n2;100\n1,25;60\n0,8;20\n0,3;20\n0,2;8\n0,15;0\n");
        write_to(folder / "well.csv", "d [mm],passing [%]\n0.1,0\n0.15,10\n0.25,30\n0.4,55\n0.63,80\n1,100\n");
        // Sandy gravel; what passes the finest sieve was not measured further.
        write_to(
            folder / "wide gravel.csv",
            "d [mm],passing [%]\n0.063,4\n0.1,9\n0.2,17\n0.3,21\n1,24\n2,31\n4,45\n8,66\n16,88\n31.5,100\n"
        );
    }
};

} // namespace suffuse::test
