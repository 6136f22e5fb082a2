#pragma once

namespace brume::coefficient {

// Coefficients and limits of the kernels in single precision; the shaders' are generated from them.
// Polynomials have the highest power first.

inline constexpr double sqrt_pi = 1.77245385090551602730;

// Divisors are at least this: the quotient is finite, and no value of a picture is as small.
inline constexpr float tiny = 1e-30f;
// What a slice holds is lit over at least this share of the slice, to both sides of its mean.
inline constexpr float min_lit_share = 1e-3f;
// exp(-T) moves the mean over a length with an optical depth of T by T / (T + this) of half of it
// to the front, for small T; what is deeper mostly grows steeply towards its far end.
inline constexpr float front_depth = 6.0f;
inline constexpr float max_front_depth = 1.0f;
// Half of the length that has the variance of a density that falls linearly to zero, per third of
// the length over which it falls: sqrt(3 / 2).
inline constexpr float falling_reach = 1.22474487f;
// What a slice holds of a Gaussian lies in its middle where it is shorter than this [radii]: to a
// twentieth of the slice.
inline constexpr float short_slice = 0.25f;
// Squared lengths up to this are too short to define a direction.
inline constexpr float tiny_square = 1e-37f;
// The same of the sine of an angle, where directions are unit.
inline constexpr float tiny_sine_square = 1e-14f;

// erfcx(x) = t P(t), t = 1 / (1 + x / 2): relative error 3e-7 up to 20, 4e-6 beyond.
inline constexpr float erfcx[] = {-0.0569184758f, 0.2754870355f,  -0.4712418020f,
                                  0.2629913824f,  -0.0183402074f, 0.2000166923f,
                                  0.2435849011f,  0.2823328376f,  0.2820876837f};

// erf(x) = x P(x^2) for |x| <= 1: relative error 2e-7.
inline constexpr float erf_small[] = {-0.00056314253f, 0.0049175541f,  -0.0267113168f,
                                      0.1128018051f,   -0.3761232495f, 1.1283791065f};

// erf(x) = x P(x^2) to 3e-5, and exactly 1 (to rounding) beyond erf_fast_end, so whole lines are
// exact: a minimax fit without exponential or division, whose error is far below that of slicing.
inline constexpr float erf_fast[] = {4.48287326e-08f,  -2.10701818e-06f, 4.373204e-05f,
                                     -5.34635078e-04f, 4.35594895e-03f,  -2.54599806e-02f,
                                     1.11661121e-01f,  -3.75768876e-01f, 1.12838748f};
inline constexpr float erf_fast_end = 3.0f;

// exp(-x^2) = (1 - y) P(y), y = erf(x)^2, to 5e-3: where a Gaussian's part lies, to 1% of its
// radius.
inline constexpr float exp_of_erf[] = {0.781783f, -0.432919f, 0.307849f, 1.0f};

// atan(x) = x P(x^2) to 2e-6 for x below atan_small_end.
inline constexpr float atan_small_end = 0.4f;
inline constexpr float atan_small[] = {-0.09090909f, 0.11111111f,  -0.14285714f,
                                       0.2f,         -0.33333333f, 1.0f};

// Gauss-Legendre with four points on [-1, 1]: those on one side, and their weights, whose sum is 1.
inline constexpr float gauss_nodes[] = {0.3399810435848563f, 0.8611363115940526f};
inline constexpr float gauss_weights[] = {0.6521451548625461f, 0.3478548451374538f};

// Gauss-Legendre with eight points on [0, 1], clustered at the far end by x -> 1 - (1 - x)^2.
struct FogRule {
  float nodes[8] = {};
  float weights[8] = {};

  constexpr FogRule() {
    constexpr double node[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                0.9602898564975363};
    constexpr double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                  0.1012285362903763};
    for (int i = 0; i < 8; ++i) {
      const double y = 0.5 * (1.0 + (i < 4 ? -node[3 - i] : node[i - 4]));
      const double wy = 0.5 * (i < 4 ? weight[3 - i] : weight[i - 4]);
      nodes[i] = static_cast<float>(1.0 - (1.0 - y) * (1.0 - y));
      weights[i] = static_cast<float>(2.0 * (1.0 - y) * wy);
    }
  }
};
inline constexpr FogRule fog_rule;
// The angle that the rule takes at once next to the peak of an isotropic phase function; a narrow
// peak's is smaller in proportion to 1 - |g|.
inline constexpr float fog_panel = 4.0f;
// Fog is left out where the path is longer than the shortest one by this optical depth.
inline constexpr float fog_detour_depth = 10.0f;
// Minimum distance of a light from a view ray that float resolves: relative to the distance along
// the ray, and absolute [u].
inline constexpr float light_rounding = 1e-6f;
inline constexpr float min_light_gap = 1e-15f;

// Mean parameter of a Gaussian on a short segment: terms of order k and k^3 of its shift.
inline constexpr float mean_shift[] = {1.0f / 6.0f, 1.0f / 90.0f};

// Below these, 1 - exp(-x) and its mean over [0, x] are taken by two terms of their series.
inline constexpr float small_increment = 1e-3f;
inline constexpr float small_exponent = 1e-2f;
// Slices behind this optical depth are invisible.
inline constexpr float visible_depth = 20.0f;

// Irradiance of a band of light on a surface, per unit of its axis' Legendre polynomial: bands 0,
// 1, 2 and 4 of sh_convolve() with clamped_cosine_sh(). The others vanish.
inline constexpr float irradiance_bands[] = {0.25f, 0.5f, 0.3125f, -0.09375f};
// Legendre polynomials P_2 and P_4 in x^2.
inline constexpr float legendre_2[] = {1.5f, -0.5f};
inline constexpr float legendre_4[] = {4.375f, -3.75f, 0.375f};

// The last sample of a table is reached from below: a look-up reads the next one too.
inline constexpr float table_end = 1.001f;
// Float cannot distinguish cells of a lattice beyond this.
inline constexpr float max_lattice_distance = 1e9f;

}  // namespace brume::coefficient
