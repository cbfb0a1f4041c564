#include "image/flip_color.h"

#include <cmath>
#include <cstddef>

namespace alpenglow::flip {

namespace {

using Row = std::array<double, 3>;
using Matrix = std::array<Row, 3>;

/// Linear Rec.709 to XYZ in exact fractions, from the primaries and the D65 white point, as the authors' code has it.
constexpr Matrix XYZ_FROM_RGB{{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                               {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                               {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

/// Each row over its sum: XYZ over the XYZ of white.
constexpr Matrix relative(Matrix m) {
    for (Row& row : m) {
        double const sum = row[0] + row[1] + row[2];
        for (double& value : row) value /= sum;
    }
    return m;
}

constexpr Matrix inverse(Matrix const& m) {
    auto const minor = [&](std::size_t r, std::size_t c) {
        return m[(r + 1) % 3][(c + 1) % 3] * m[(r + 2) % 3][(c + 2) % 3] -
               m[(r + 1) % 3][(c + 2) % 3] * m[(r + 2) % 3][(c + 1) % 3];
    };
    double const determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    Matrix result{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) result[c][r] = minor(r, c) / determinant;
    }
    return result;
}

using FloatMatrix = std::array<Color, 3>;

constexpr FloatMatrix rounded(Matrix const& m) {
    FloatMatrix result{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) result[r][c] = static_cast<float>(m[r][c]);
    }
    return result;
}

/// White is (1, 1, 1) on both sides.
constexpr FloatMatrix RELATIVE_FROM_RGB = rounded(relative(XYZ_FROM_RGB));
constexpr FloatMatrix RGB_FROM_RELATIVE = rounded(inverse(relative(XYZ_FROM_RGB)));

Color operator*(FloatMatrix const& m, Color const& v) {
    Color result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

/// CIELAB's cube root with its straight start.
float lab_curve(float t) {
    constexpr float delta = 6.0f / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0f / 29;
}

} // namespace

Color ycxcz_from_rgb(Color const& rgb) {
    Color const t = RELATIVE_FROM_RGB * rgb;
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

Color rgb_from_ycxcz(Color const& ycxcz) {
    float const y = (ycxcz[0] + 16) / 116;
    return RGB_FROM_RELATIVE * Color{y + ycxcz[1] / 500, y, y - ycxcz[2] / 200};
}

Color hunt_lab_from_rgb(Color const& rgb) {
    Color const t = RELATIVE_FROM_RGB * rgb;
    float const x = lab_curve(t[0]), y = lab_curve(t[1]), z = lab_curve(t[2]), lightness = 116 * y - 16;
    return {lightness, 0.01f * lightness * 500 * (x - y), 0.01f * lightness * 200 * (y - z)};
}

float hyab(Color const& a, Color const& b) {
    float const da = a[1] - b[1], db = a[2] - b[2];
    return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

float color_error(float distance) {
    constexpr float power = 0.7f, knee = 0.4f, knee_value = 0.95f;
    static float const largest = std::pow(hyab(hunt_lab_from_rgb({0, 1, 0}), hunt_lab_from_rgb({0, 0, 1})), power);
    float const compressed = std::pow(distance, power), knee_at = knee * largest;
    if (compressed < knee_at) return compressed * knee_value / knee_at;
    return knee_value + (compressed - knee_at) / (largest - knee_at) * (1 - knee_value);
}

} // namespace alpenglow::flip
