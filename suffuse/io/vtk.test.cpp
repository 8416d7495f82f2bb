#include "suffuse/io/vtk.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <cstring>
#include <map>
#include <set>

namespace suffuse::io {
namespace {

using test::TempFolder;

using Attributes = std::map<std::string, std::string>;

/// A reader of what we write, independent of the writer: elements with attributes, arrays at their offsets.
class VtkFile {
public:
    explicit VtkFile(const std::filesystem::path& path) : text_(test::read_all(path)) {
        const std::string marker = "<AppendedData encoding=\"raw\">\n_";
        const std::size_t start = text_.find(marker);
        data_ = start == std::string::npos ? text_.size() : start + marker.size();
        xml_ = text_.substr(0, start == std::string::npos ? text_.size() : start);
        parse();
    }

    /// Attributes of the first element of that name.
    [[nodiscard]] Attributes element(const std::string& name) const {
        const auto found = elements_.find(name);
        return found == elements_.end() ? Attributes{} : found->second;
    }

    template <class T>
    [[nodiscard]] std::vector<T> array(const std::string& name, const std::string& type) const {
        const Attributes& a = arrays_.at(name);
        EXPECT_EQ(a.at("type"), type);
        const std::size_t at = data_ + std::stoul(a.at("offset"));
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, text_.data() + at, sizeof bytes);
        EXPECT_EQ(bytes % sizeof(T), 0U);
        std::vector<T> values(bytes / sizeof(T));
        std::memcpy(values.data(), text_.data() + at + sizeof bytes, bytes);
        return values;
    }

    /// Whether the arrays follow one another without gaps and the file ends right behind the last.
    [[nodiscard]] bool is_gapless() const {
        std::set<std::size_t> offsets;
        for (const auto& [name, a] : arrays_) {
            offsets.insert(std::stoul(a.at("offset")));
        }
        std::size_t at = 0;
        for (const std::size_t offset : offsets) {
            if (offset != at) {
                return false;
            }
            std::uint64_t bytes = 0;
            std::memcpy(&bytes, text_.data() + data_ + at, sizeof bytes);
            at += sizeof bytes + bytes;
        }
        return text_.substr(data_ + at) == "\n</AppendedData>\n</VTKFile>\n";
    }

    bool balanced = true; ///< every element is closed in order; the appended data closes the outermost

private:
    void parse() {
        std::vector<std::string> open;
        for (std::size_t at = xml_.find('<'); at != std::string::npos; at = xml_.find('<', at + 1)) {
            const std::size_t end = xml_.find('>', at);
            std::string tag = xml_.substr(at + 1, end - at - 1);
            if (tag[0] == '?') {
                continue;
            }
            if (tag[0] == '/') {
                balanced = balanced && !open.empty() && open.back() == tag.substr(1);
                if (!open.empty()) {
                    open.pop_back();
                }
                continue;
            }
            const bool closed = tag.back() == '/';
            if (closed) {
                tag.pop_back();
            }
            const std::string name = tag.substr(0, tag.find(' '));
            const Attributes attributes = attributes_of(tag);
            if (name == "DataArray") {
                arrays_[attributes.at("Name")] = attributes;
            }
            elements_.emplace(name, attributes);
            if (!closed) {
                open.push_back(name);
            }
        }
        const bool appended = data_ < text_.size();
        balanced = balanced && open == (appended ? std::vector<std::string>{"VTKFile"} : std::vector<std::string>{});
    }

    static Attributes attributes_of(const std::string& tag) {
        Attributes found;
        for (std::size_t equals = tag.find("=\""); equals != std::string::npos; equals = tag.find("=\"", equals + 1)) {
            const std::size_t space = tag.rfind(' ', equals), quote = tag.find('"', equals + 2);
            found[tag.substr(space + 1, equals - space - 1)] = tag.substr(equals + 2, quote - equals - 2);
            equals = quote;
        }
        return found;
    }

    std::string text_, xml_;
    std::size_t data_ = 0;
    std::map<std::string, Attributes> elements_, arrays_;
};

/// Two touching grains, the second outside the cell.
dem::World small_world() {
    dem::World world;
    world.cell.h = diagonal({4, 4, 4});
    grains::add_grain(world.grains, {1, 1, 1}, 0.5, 2600);
    grains::add_grain(world.grains, {-2.25, 1, 1}, 0.5, 2600);
    world.grains.id = {5, 2};
    world.grains.fine = {0, 1};
    world.grains.velocity[1] = {1, 2, 3};
    world.contacts.first = {0}, world.contacts.second = {1}, world.contacts.image = {{1, 0, 0}};
    for (contact::VectorColumn* column :
         {&world.contacts.shear_force, &world.contacts.bending, &world.contacts.normal}) {
        column->resize(1);
    }
    world.contacts.overlap = {0.25};
    world.contacts.normal.set(0, {1, 0, 0});
    world.contacts.shear_force.set(0, {0, 3, 4});
    return world;
}

TEST(Vtk, GrainsArePointsInsideTheCellWithTheirColumns) {
    const TempFolder folder;
    write_grains_vtp(folder / "g.vtp", small_world(), {vtk_vectors("fluid_force", {{1, 0, 0}, {0, 1, 0}})});
    const VtkFile file(folder / "g.vtp");
    EXPECT_TRUE(file.balanced);
    EXPECT_TRUE(file.is_gapless());
    EXPECT_EQ(file.element("VTKFile").at("type"), "PolyData");
    EXPECT_EQ(file.element("VTKFile").at("header_type"), "UInt64");
    EXPECT_EQ(file.element("Piece").at("NumberOfPoints"), "2");
    EXPECT_EQ(file.element("Piece").at("NumberOfVerts"), "2");
    EXPECT_EQ(file.array<float>("position", "Float32"), (std::vector<float>{1, 1, 1, 1.75F, 1, 1}));
    EXPECT_EQ(file.array<float>("radius", "Float32"), (std::vector<float>{0.5F, 0.5F}));
    EXPECT_EQ(file.array<std::uint32_t>("id", "UInt32"), (std::vector<std::uint32_t>{5, 2}));
    EXPECT_EQ(file.array<std::uint8_t>("fine", "UInt8"), (std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(file.array<std::int64_t>("coordination", "Int64"), (std::vector<std::int64_t>{1, 1}));
    EXPECT_EQ(file.array<float>("velocity", "Float32"), (std::vector<float>{0, 0, 0, 1, 2, 3}));
    EXPECT_EQ(file.array<float>("fluid_force", "Float32"), (std::vector<float>{1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(file.array<std::int64_t>("connectivity", "Int64"), (std::vector<std::int64_t>{0, 1}));
    EXPECT_EQ(file.array<std::int64_t>("offsets", "Int64"), (std::vector<std::int64_t>{1, 2}));
    EXPECT_THROW(write_grains_vtp(folder / "g.vtp", small_world(), {vtk_scalars("pass", {1})}), Bug);
}

TEST(Vtk, AGrainBroughtHomeMovesAsTheMeanMotionDoesThere) {
    const TempFolder folder;
    dem::World world = small_world();
    world.cell.velocity_gradient(0, 0) = 0.5; // the second grain comes from a period away, 4 m
    write_grains_vtp(folder / "g.vtp", world);
    const VtkFile file(folder / "g.vtp");
    EXPECT_EQ(file.array<float>("velocity", "Float32"), (std::vector<float>{0, 0, 0, 3, 2, 3}));
}

TEST(Vtk, ContactsAreLinesBetweenCenters) {
    const TempFolder folder;
    const dem::World world = small_world();
    write_contacts_vtp(folder / "c.vtp", world);
    const VtkFile file(folder / "c.vtp");
    EXPECT_TRUE(file.balanced);
    EXPECT_TRUE(file.is_gapless());
    EXPECT_EQ(file.element("Piece").at("NumberOfLines"), "1");
    EXPECT_EQ(file.array<float>("position", "Float32"), (std::vector<float>{1, 1, 1, 1.75F, 1, 1}));
    EXPECT_EQ(file.array<std::int64_t>("offsets", "Int64"), (std::vector<std::int64_t>{2}));
    const auto force = static_cast<float>(world.material.modulus * 0.5 * 0.25); // kn = E r for equal grains
    EXPECT_EQ(file.array<float>("normal_force", "Float32"), std::vector<float>{force});
    EXPECT_EQ(file.array<float>("shear_force", "Float32"), std::vector<float>{5});
}

TEST(Vtk, PoresAreTetrahedra) {
    const TempFolder folder;
    const std::array<Vec3, 4> pore{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    write_pores_vtu(folder / "p.vtu", {pore, pore}, {vtk_scalars("pressure", {7, 8})});
    const VtkFile file(folder / "p.vtu");
    EXPECT_TRUE(file.balanced);
    EXPECT_TRUE(file.is_gapless());
    EXPECT_EQ(file.element("VTKFile").at("type"), "UnstructuredGrid");
    EXPECT_EQ(file.element("Piece").at("NumberOfCells"), "2");
    EXPECT_EQ(file.array<float>("position", "Float32").size(), 24U);
    EXPECT_EQ(file.array<std::uint8_t>("types", "UInt8"), (std::vector<std::uint8_t>{10, 10}));
    EXPECT_EQ(file.array<std::int64_t>("offsets", "Int64"), (std::vector<std::int64_t>{4, 8}));
    EXPECT_EQ(file.array<float>("pressure", "Float32"), (std::vector<float>{7, 8}));
}

TEST(Vtk, CellOutlineHasTwelveEdgesOfTheVectorsOfTheCell) {
    const TempFolder folder;
    cell::Cell cell;
    cell.h = from_columns({2, 0, 0}, {0.5, 3, 0}, {0, 0, 4});
    write_cell_vtp(folder / "cell.vtp", cell);
    const VtkFile file(folder / "cell.vtp");
    EXPECT_TRUE(file.balanced);
    EXPECT_TRUE(file.is_gapless());
    const auto x = file.array<float>("position", "Float32");
    const auto corner = file.array<std::int64_t>("connectivity", "Int64");
    ASSERT_EQ(corner.size(), 24U);
    std::map<std::array<float, 3>, int> edges;
    for (std::size_t k = 0; k < corner.size(); k += 2) {
        const auto from = 3 * static_cast<std::size_t>(corner[k]), to = 3 * static_cast<std::size_t>(corner[k + 1]);
        ++edges[{x[to] - x[from], x[to + 1] - x[from + 1], x[to + 2] - x[from + 2]}];
    }
    EXPECT_EQ(edges, (std::map<std::array<float, 3>, int>{{{2, 0, 0}, 4}, {{0.5, 3, 0}, 4}, {{0, 0, 4}, 4}}));
}

TEST(Vtk, WorldWithoutContactsGivesAnEmptyFileThatIsStillWhole) {
    const TempFolder folder;
    dem::World world = small_world();
    world.contacts = {};
    write_contacts_vtp(folder / "c.vtp", world);
    const VtkFile file(folder / "c.vtp");
    EXPECT_TRUE(file.balanced);
    EXPECT_EQ(file.element("Piece").at("NumberOfLines"), "0");
}

TEST(Vtk, CollectionNamesItsFilesSafely) {
    const TempFolder folder;
    write_pvd(folder / "a.pvd", {{0, "a.vtp"}, {0.5, "b & \"c\".vtp", 1}});
    const std::string text = test::read_all(folder / "a.pvd");
    EXPECT_TRUE(VtkFile(folder / "a.pvd").balanced);
    EXPECT_NE(text.find("timestep=\"0.5\" part=\"1\" file=\"b &amp; &quot;c&quot;.vtp\"/>"), std::string::npos);
}

} // namespace
} // namespace suffuse::io
