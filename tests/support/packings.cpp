#include "tests/support/packings.hpp"

#include <nlohmann/json.hpp>

#include "tests/support/reference.hpp"
#include <sstream>

namespace suffuse::test {

Packing reference_spheres(const std::string& name) {
    Packing packing;
    const nlohmann::json about = read_reference_json(name + ".json");
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
            packing.h(a, b) = about["hSize"][static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
        }
    }
    std::istringstream rows(read_reference(name + ".csv.gz"));
    std::string line;
    std::getline(rows, line);
    while (std::getline(rows, line)) {
        for (char& c : line) {
            c = c == ',' ? ' ' : c;
        }
        std::istringstream row(line);
        Vec3 x;
        double r = 0;
        row >> x.x >> x.y >> x.z >> r;
        packing.position.push_back(x);
        packing.radius.push_back(r);
    }
    return packing;
}

} // namespace suffuse::test
