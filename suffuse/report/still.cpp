#include "suffuse/report/still.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/report/packed.hpp"

#include <algorithm>
#include <cmath>
#include <zlib.h>

namespace suffuse::report {

namespace {

using Rgb = std::array<double, 3>;

constexpr Rgb coarse_color = {0xcf, 0xa4, 0x57}, fines_color = {0xc8, 0x32, 0x2b};
constexpr int shades = 40; ///< of each fraction: few enough to compress well, enough to look round
constexpr std::uint8_t background = 0, outline = 1, first_coarse = 2, first_fine = first_coarse + shades;

/// Directions of the picture: right, up and toward the eye; seen from above a corner, z upward.
struct Camera {
    Vec3 right, up, eye;
    double scale = 1; ///< pixels a meter
    Vec3 center;      ///< in the middle of the picture
    int pixels = 0;

    [[nodiscard]] Vec3 project(const Vec3& x) const {
        const Vec3 from = x - center;
        return {0.5 * pixels + scale * dot(from, right), 0.5 * pixels - scale * dot(from, up), scale * dot(from, eye)};
    }
};

Vec3 unit(const Vec3& v) {
    return v / norm(v);
}

Vec3 corner(const Mat3& h, int k) {
    return h * Vec3{static_cast<double>(k & 1), static_cast<double>(k >> 1 & 1), static_cast<double>(k >> 2 & 1)};
}

Camera camera_for(const Scene& scene, const SceneState& state, int pixels) {
    Camera camera;
    camera.eye = unit({1, -1.6, 0.9});
    camera.right = unit(cross({0, 0, 1}, camera.eye));
    camera.up = cross(camera.eye, camera.right);
    camera.pixels = pixels;
    camera.center = state.h * Vec3{0.5, 0.5, 0.5};
    const double widest = scene.radius.empty() ? 0 : *std::max_element(scene.radius.begin(), scene.radius.end());
    double reach = 0; // the same for all states, so that they can be compared
    for (const SceneState& each : scene.states) {
        for (int k = 0; k < 8; ++k) {
            const Vec3 from = corner(each.h, k) - each.h * Vec3{0.5, 0.5, 0.5};
            reach = std::max({reach, std::abs(dot(from, camera.right)), std::abs(dot(from, camera.up))});
        }
    }
    camera.scale = reach + widest > 0 ? 0.5 * pixels / (1.01 * (reach + widest)) : 1;
    return camera;
}

/// Color indices with the depth of what is nearest to the eye.
struct Canvas {
    explicit Canvas(int size)
        : pixels(size), index(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), background),
          depth(index.size(), -std::numeric_limits<double>::infinity()) {}

    void put(int column, int row, double z, std::uint8_t color) {
        if (column < 0 || row < 0 || column >= pixels || row >= pixels) {
            return;
        }
        const std::size_t at =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels) + static_cast<std::size_t>(column);
        if (z > depth[at]) {
            depth[at] = z;
            index[at] = color;
        }
    }

    int pixels;
    std::vector<std::uint8_t> index;
    std::vector<double> depth;
};

void draw_sphere(Canvas& canvas, const Vec3& center, double radius, std::uint8_t first_shade) {
    const Vec3 light = unit({-0.45, 0.6, 0.75}); // in the picture's right, up, eye
    const auto low = [](double x) { return static_cast<int>(std::floor(x)); };
    for (int row = low(center.y - radius); row <= low(center.y + radius); ++row) {
        for (int column = low(center.x - radius); column <= low(center.x + radius); ++column) {
            const double x = (column + 0.5 - center.x) / radius, y = -(row + 0.5 - center.y) / radius;
            const double rest = 1 - x * x - y * y;
            if (rest < 0) {
                continue;
            }
            const double z = std::sqrt(rest);
            const double lit = std::max(0.0, dot({x, y, z}, light));
            const double rim = std::clamp(z / 0.45, 0.35, 1.0); // a dark rim distinguishes touching grains
            const double shade = std::clamp(rim * (0.42 + 0.58 * lit), 0.0, 1.0);
            canvas.put(
                column, row, center.z + radius * z,
                static_cast<std::uint8_t>(first_shade + std::lround(shade * (shades - 1)))
            );
        }
    }
}

void draw_edge(Canvas& canvas, const Vec3& from, const Vec3& to) {
    const int steps = 1 + static_cast<int>(2 * std::hypot(to.x - from.x, to.y - from.y));
    for (int k = 0; k <= steps; ++k) {
        const Vec3 at = from + (static_cast<double>(k) / steps) * (to - from);
        for (const int dx : {0, 1}) {
            for (const int dy : {0, 1}) {
                canvas.put(static_cast<int>(at.x) + dx, static_cast<int>(at.y) + dy, at.z, outline);
            }
        }
    }
}

std::vector<std::array<std::uint8_t, 4>> palette() {
    std::vector<std::array<std::uint8_t, 4>> colors = {{255, 255, 255, 0}, {110, 110, 110, 255}};
    for (const Rgb& color : {coarse_color, fines_color}) {
        for (int s = 0; s < shades; ++s) {
            const double shade = static_cast<double>(s) / (shades - 1);
            const double gloss = std::pow(shade, 12) * 45;
            std::array<std::uint8_t, 4> mixed{0, 0, 0, 255};
            for (std::size_t c = 0; c < 3; ++c) {
                mixed[c] = static_cast<std::uint8_t>(std::clamp(color[c] * (0.12 + 0.95 * shade) + gloss, 0.0, 255.0));
            }
            colors.push_back(mixed);
        }
    }
    return colors;
}

void put_number(std::string& out, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0}) {
        out += static_cast<char>(value >> shift & 255);
    }
}

void put_chunk(std::string& out, const char* name, const std::string& content) {
    put_number(out, static_cast<std::uint32_t>(content.size()));
    const std::string checked = name + content;
    out += checked;
    const auto* bytes = reinterpret_cast<const Bytef*>(checked.data());
    put_number(out, static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(checked.size()))));
}

} // namespace

std::string still_picture(const Scene& scene, const SceneState& state, int pixels) {
    const Camera camera = camera_for(scene, state, pixels);
    Canvas canvas(pixels);
    for (std::size_t g = 0; g < scene.id.size(); ++g) {
        if (is_present(scene, state, g)) {
            draw_sphere(
                canvas, camera.project(state.position[g]), camera.scale * scene.radius[g],
                scene.fine[g] != 0 ? first_fine : first_coarse
            );
        }
    }
    for (int k = 0; k < 8; ++k) {
        for (int a = 0; a < 3; ++a) {
            if ((k & 1 << a) == 0) {
                draw_edge(canvas, camera.project(corner(state.h, k)), camera.project(corner(state.h, k | 1 << a)));
            }
        }
    }
    return png_of(pixels, pixels, canvas.index, palette());
}

std::string png_of(
    int width, int height, const std::vector<std::uint8_t>& index,
    const std::vector<std::array<std::uint8_t, 4>>& palette
) {
    expects(width > 0 && height > 0 && palette.size() <= 256, "a picture has pixels, and at most 256 colors");
    expects(
        index.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
        "a picture has one index a pixel"
    );
    std::string header, colors, opacity, rows;
    put_number(header, static_cast<std::uint32_t>(width));
    put_number(header, static_cast<std::uint32_t>(height));
    header += std::string("\x08\x03\x00\x00\x00", 5); // 8 bits, indexed, deflate, the usual filters, not interlaced
    for (const auto& [red, green, blue, alpha] : palette) {
        colors += {static_cast<char>(red), static_cast<char>(green), static_cast<char>(blue)};
        opacity += static_cast<char>(alpha);
    }
    for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row) {
        rows += '\0'; // no filter: indices have no smooth differences
        const auto begin = index.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(width));
        rows.append(begin, begin + width);
    }
    std::string png = "\x89PNG\r\n\x1a\n";
    put_chunk(png, "IHDR", header);
    put_chunk(png, "PLTE", colors);
    put_chunk(png, "tRNS", opacity);
    put_chunk(png, "IDAT", deflated(rows));
    put_chunk(png, "IEND", "");
    return png;
}

} // namespace suffuse::report
