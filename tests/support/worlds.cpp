#include "tests/support/worlds.hpp"

#include <nlohmann/json.hpp>

#include "tests/support/reference.hpp"
#include <sstream>

namespace suffuse::test {

dem::World reference_packing(const std::string& name) {
    const nlohmann::json about = nlohmann::json::parse(read_reference(name + ".json"));
    const nlohmann::json& law = about["params"];
    dem::World world;
    world.material.modulus = law["young"];
    world.material.shear_ratio = law["poisson"];
    world.material.friction = radians(law["phiDeg"]);
    world.material.density = law["density"];
    world.material.rolling_stiffness = law["alphaKr"];
    world.material.rolling_friction = law["etaRoll"];
    world.cell.h = diagonal({about["cell"][0], about["cell"][1], about["cell"][2]});
    world.reference_h = world.cell.h;
    std::istringstream rows(read_reference(name + ".csv.gz"));
    std::string line;
    std::getline(rows, line); // the names of the columns
    while (std::getline(rows, line)) {
        std::istringstream row(line);
        Vec3 x;
        double r = 0;
        char comma = 0;
        row >> x.x >> comma >> x.y >> comma >> x.z >> comma >> r;
        add(world, x, r);
    }
    return world;
}

} // namespace suffuse::test
