#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H

#include <Shape_characteristics/curvature/internal/Adaptive_statistics.h>

#include <array>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// The constants of adaptive_curvatures(), learned from surfaces whose curvature is known. Not written by hand: they are the
// output of
//   benchmark_adaptive_adaptive --calibrate adaptive_scores.h

// where EXACT_3_ANGLES - POINTS_3_ANGLES is less, EXACT_3_RINGS is chosen
inline constexpr double adaptive_exactness = -1.6000;

// Elsewhere the estimators are blended in proportion to exp(-score): a linear function of these statistics.
// clang-format off
inline constexpr std::array<Adaptive_statistic, 42> adaptive_score_statistics = {{
    Adaptive_statistic::EXACT_2_ANGLES,
    Adaptive_statistic::EXACT_3_ANGLES,
    Adaptive_statistic::POINTS_2_ANGLES,
    Adaptive_statistic::POINTS_3_ANGLES,
    Adaptive_statistic::POINTS_4_ANGLES,
    Adaptive_statistic::NORMALS_3_ANGLES,
    Adaptive_statistic::SMOOTHED_3_ANGLES,
    Adaptive_statistic::SMOOTHED_4_ANGLES,
    Adaptive_statistic::GENTLY_4_ANGLES,
    Adaptive_statistic::BARELY_4_ANGLES,
    Adaptive_statistic::EXACT_2_TURNS,
    Adaptive_statistic::EXACT_3_TURNS,
    Adaptive_statistic::POINTS_2_TURNS,
    Adaptive_statistic::POINTS_3_TURNS,
    Adaptive_statistic::POINTS_4_TURNS,
    Adaptive_statistic::NORMALS_3_TURNS,
    Adaptive_statistic::SMOOTHED_3_TURNS,
    Adaptive_statistic::SMOOTHED_4_TURNS,
    Adaptive_statistic::GENTLY_4_TURNS,
    Adaptive_statistic::BARELY_4_TURNS,
    Adaptive_statistic::EXACT_2_EXACT_3,
    Adaptive_statistic::POINTS_2_POINTS_3,
    Adaptive_statistic::POINTS_3_POINTS_4,
    Adaptive_statistic::EXACT_3_POINTS_3,
    Adaptive_statistic::EXACT_3_NORMALS_3,
    Adaptive_statistic::POINTS_3_NORMALS_3,
    Adaptive_statistic::POINTS_3_SMOOTHED_3,
    Adaptive_statistic::POINTS_4_SMOOTHED_4,
    Adaptive_statistic::NORMALS_3_SMOOTHED_3,
    Adaptive_statistic::SMOOTHED_3_SMOOTHED_4,
    Adaptive_statistic::SMOOTHED_3_GENTLY_4,
    Adaptive_statistic::SMOOTHED_4_GENTLY_4,
    Adaptive_statistic::GENTLY_4_BARELY_4,
    Adaptive_statistic::POINTS_4_BARELY_4,
    Adaptive_statistic::POINTS_3_NORMALS,
    Adaptive_statistic::SMOOTHED_3_NORMALS,
    Adaptive_statistic::POINTS_3_BEND,
    Adaptive_statistic::SMOOTHED_3_BEND,
    Adaptive_statistic::SMOOTHED_3_MOVES,
    Adaptive_statistic::SMOOTHED_3_DRIFT,
    Adaptive_statistic::NOISE,
    Adaptive_statistic::IRREGULARITY}};
inline constexpr std::array<std::array<double, number_of_adaptive_candidates>, 43> adaptive_score_weights = {{
    {{-14.0629, -11.2906, -13.6320, -14.8624, -10.6998, -15.4886, 3.8903, -4.7234, -12.7609, 4.2151}}, // 1
    {{0.5324, 2.8816, -0.3627, -1.7050, -0.4885, -2.0619, -1.3322, 1.2974, -0.8162, -0.5991}}, // EXACT_2_ANGLES
    {{0.4899, 2.6423, 1.1564, -1.3749, -0.3741, -1.7964, -0.3934, -0.3857, -0.8843, -1.7981}}, // EXACT_3_ANGLES
    {{0.1938, -1.7688, 3.1486, 0.3340, 0.9749, -0.4540, 0.1935, -1.9263, -1.5084, -0.0603}}, // POINTS_2_ANGLES
    {{-0.0706, -1.0784, -2.5783, 3.0497, -0.7902, -0.1126, 0.4552, 1.9612, 0.7230, -0.0290}}, // POINTS_3_ANGLES
    {{0.1835, -1.7934, -2.1249, 0.6435, 5.1201, -1.0160, -0.7644, -1.5789, -0.1900, -0.4491}}, // POINTS_4_ANGLES
    {{-0.1756, -0.8078, -0.2604, -0.4120, 0.4059, 2.1938, 0.6991, -1.3834, -1.1776, -1.0442}}, // NORMALS_3_ANGLES
    {{0.1131, -0.6203, -0.8207, 0.2187, -0.3523, 0.2956, 0.4645, 0.9029, 0.5154, 0.0613}}, // SMOOTHED_3_ANGLES
    {{0.0215, -0.3452, -1.1629, -0.8462, -0.5766, 0.0303, 0.1788, 1.6718, 1.7299, 0.4731}}, // SMOOTHED_4_ANGLES
    {{0.0749, -0.2878, -1.2749, -0.4609, -0.6350, 0.1531, 0.2483, 0.8746, 1.5974, 0.5296}}, // GENTLY_4_ANGLES
    {{-0.1980, 0.5315, 0.1201, -0.4890, -1.0737, -0.7321, 0.3594, -0.2476, -0.0942, 1.1950}}, // BARELY_4_ANGLES
    {{-0.1075, -0.7167, -0.2961, 0.5825, 0.2360, -2.9279, 0.6548, 0.8533, 1.1976, -0.4948}}, // EXACT_2_TURNS
    {{-0.3878, 1.1086, -1.8078, -1.3585, -0.9495, 3.6746, -0.4145, -4.5479, -2.4980, 1.4066}}, // EXACT_3_TURNS
    {{0.2953, -0.8868, 3.5232, -1.1866, 1.5058, -0.3659, -1.7785, -1.3184, -1.0409, 0.8431}}, // POINTS_2_TURNS
    {{-0.1044, -0.0239, -0.6391, 3.5113, -1.6149, -0.0680, 0.6440, -0.5839, -0.4343, -0.0791}}, // POINTS_3_TURNS
    {{0.5338, 0.4121, 1.0899, -1.5181, 1.4735, -0.4436, -0.9889, -0.6982, -1.1372, -0.5675}}, // POINTS_4_TURNS
    {{-1.0376, -3.1907, -1.0048, -2.1313, -2.2238, 7.6223, -2.0331, -1.5515, -1.9179, 0.1175}}, // NORMALS_3_TURNS
    {{-0.8513, -0.8020, -0.7855, 0.2541, -1.7206, 1.2057, 1.3883, -0.3192, 2.2137, 0.0940}}, // SMOOTHED_3_TURNS
    {{-0.5616, 0.6836, 0.2966, -0.1405, 0.6306, -1.8233, -1.5436, 2.9298, -3.8053, 0.2311}}, // SMOOTHED_4_TURNS
    {{-0.7250, 0.0283, -0.6102, -0.2147, -1.2373, -4.1463, 1.2239, 1.3238, 1.5065, 0.3921}}, // GENTLY_4_TURNS
    {{-0.5040, -0.2129, -0.4218, -0.7165, 0.5092, -0.0804, 1.5730, -0.4264, -0.3186, 0.6796}}, // BARELY_4_TURNS
    {{1.4474, 3.7709, -1.0441, -1.5789, -1.4116, -3.0546, -1.2483, -1.5964, -1.2264, -1.2404}}, // EXACT_2_EXACT_3
    {{0.1795, -1.4915, 2.7669, 1.2233, 0.4586, -0.1385, -0.5702, -0.7282, -0.9133, -0.2474}}, // POINTS_2_POINTS_3
    {{-0.1170, -0.1851, 0.0155, 0.2440, 1.6970, -1.0464, -0.4643, -1.2730, -1.2821, 0.8191}}, // POINTS_3_POINTS_4
    {{-0.3116, -1.1416, 0.6598, 1.6084, -0.0889, -0.5123, -0.8779, 0.4857, -0.1864, 0.1815}}, // EXACT_3_POINTS_3
    {{0.4423, -0.2295, -2.1716, -0.4388, -0.4548, 3.3298, -0.7218, -0.4198, -0.3094, -1.6249}}, // EXACT_3_NORMALS_3
    {{-0.1271, 1.5855, 1.3605, 0.1036, -0.7658, 1.0718, -0.7906, -3.2551, -0.3568, -0.8039}}, // POINTS_3_NORMALS_3
    {{0.1766, 0.2732, -0.8115, 1.2833, 0.2289, -1.1073, 0.2888, -0.5488, -0.4724, 0.0326}}, // POINTS_3_SMOOTHED_3
    {{0.0072, -0.3624, -1.1169, -1.0210, 0.8821, -0.3132, 0.5358, 0.6665, 1.4854, -0.6047}}, // POINTS_4_SMOOTHED_4
    {{-0.3497, -1.4305, -0.1086, 0.2152, 0.2593, 0.2568, -0.7002, 3.1759, 1.0899, -1.0059}}, // NORMALS_3_SMOOTHED_3
    {{-0.3162, -1.0474, -0.1935, -2.3976, -0.7706, 0.2636, 0.3990, 2.3776, 1.6148, 1.0564}}, // SMOOTHED_3_SMOOTHED_4
    {{-0.4584, -1.0386, -0.8863, -1.1057, -1.7711, -1.0697, 1.1249, 0.5865, 3.0966, 1.3150}}, // SMOOTHED_3_GENTLY_4
    {{-0.0156, 0.0928, -0.0898, 0.1827, -0.0379, -0.0275, -0.0058, 0.6426, -1.0826, 0.1919}}, // SMOOTHED_4_GENTLY_4
    {{0.0266, 0.2118, -0.2361, -1.1613, 0.7325, -1.3179, 0.7913, -0.7183, -1.9029, 1.3162}}, // GENTLY_4_BARELY_4
    {{-0.0476, 0.2550, -0.3644, -0.3320, 0.6878, 0.3503, 0.5113, -0.8959, -0.9309, -0.8626}}, // POINTS_4_BARELY_4
    {{-0.9753, 0.3008, -0.0478, 1.1510, 0.0383, -0.7159, -0.8427, -0.3217, -0.4675, -0.5445}}, // POINTS_3_NORMALS
    {{-1.4562, -1.3526, 1.3395, -1.1407, -2.4489, 2.7099, -0.1517, -0.5118, -0.1349, -0.2731}}, // SMOOTHED_3_NORMALS
    {{-0.1233, -0.2991, -2.9993, -2.1491, -1.0883, -0.3028, 2.2594, 5.0894, 3.7404, -1.9235}}, // POINTS_3_BEND
    {{-0.1733, 2.4046, 3.3882, 0.9808, 2.1720, -1.2024, -2.1109, -3.1476, -3.3200, -2.3075}}, // SMOOTHED_3_BEND
    {{-0.2701, -0.1394, -1.1859, -0.1097, -1.5549, -0.9028, 0.7971, -0.2281, 2.4843, 1.0172}}, // SMOOTHED_3_MOVES
    {{-0.2540, -0.0561, 0.1528, -0.2350, 0.0924, -0.2560, 0.4292, 0.1092, -0.1395, 0.0527}}, // SMOOTHED_3_DRIFT
    {{-0.0301, 0.1342, 1.3888, -0.1162, 0.8800, -1.4862, 0.0752, 0.1077, -1.4075, 0.3635}}, // NOISE
    {{7.6017, -0.2417, 0.8545, -2.4844, -1.0246, -3.1106, -1.2745, -1.0045, -0.5925, -0.0976}}}}; // IRREGULARITY
// clang-format on

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H
