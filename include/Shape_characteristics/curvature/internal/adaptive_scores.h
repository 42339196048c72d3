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
inline constexpr double adaptive_exactness = -1.4500;

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
    {{-11.0845, -7.7358, -10.8361, -12.7413, -6.8848, -14.6516, 3.0070, -5.4034, -11.4598, -2.7185}}, // 1
    {{0.4283, 3.5075, -0.4915, -1.7883, 0.0941, -1.3603, -0.9086, 0.2451, -1.2288, 0.0298}}, // EXACT_2_ANGLES
    {{0.5596, 3.0451, 1.7918, -0.5486, 0.4341, -3.5795, 0.7141, -1.6063, -2.3365, -0.5797}}, // EXACT_3_ANGLES
    {{-0.4270, -1.7342, 3.7442, 1.6444, 0.6786, -1.6738, 0.8551, -2.9780, -2.3763, -0.0006}}, // POINTS_2_ANGLES
    {{0.0944, -1.4726, -2.7981, 3.7210, -0.4403, -0.4513, 0.4982, 0.9800, 0.4861, 0.6538}}, // POINTS_3_ANGLES
    {{0.0141, -2.5585, -2.3966, -0.5284, 8.0374, -2.4646, -0.0341, -1.9971, -1.2081, 0.5884}}, // POINTS_4_ANGLES
    {{-0.0968, -0.7069, -0.8640, -0.1144, 0.7634, 2.3634, 0.5229, -0.5743, -0.8977, -2.1795}}, // NORMALS_3_ANGLES
    {{-0.0381, -1.0568, -1.5082, 1.4065, 0.1341, 1.7927, 0.4587, 0.2971, -0.5903, -0.0876}}, // SMOOTHED_3_ANGLES
    {{0.4776, -0.7881, -1.9298, -1.6825, -1.0399, 0.2497, 0.1635, 2.9262, 2.7428, 0.2616}}, // SMOOTHED_4_ANGLES
    {{0.5925, -0.5260, -2.0945, -0.7157, -0.7700, 1.0443, 0.1969, 0.6920, 2.7268, 0.4956}}, // GENTLY_4_ANGLES
    {{-0.2116, 0.8912, 0.6930, -1.1344, -3.5737, -0.8660, 0.5347, 0.4324, -0.0094, 2.2029}}, // BARELY_4_ANGLES
    {{0.2407, -1.9277, -0.4336, 0.9156, 0.1955, -2.1696, 0.5615, 0.9080, 0.9374, 0.3306}}, // EXACT_2_TURNS
    {{-0.6636, 3.1534, -1.7798, -2.2158, -0.6060, 3.0001, -0.6810, -3.9034, -1.7575, 0.1434}}, // EXACT_3_TURNS
    {{0.2865, -1.1677, 3.8264, -1.6290, 1.4359, -0.4067, -1.6336, -0.3468, -0.4556, 0.7144}}, // POINTS_2_TURNS
    {{-0.4487, 0.4652, -1.6653, 2.7549, -3.8537, 0.2156, 0.7240, 0.0183, -0.1914, 0.1955}}, // POINTS_3_TURNS
    {{0.5010, 0.3227, 0.7516, -1.4562, 0.7050, -0.0246, -1.2578, -0.1872, -0.6558, 0.6827}}, // POINTS_4_TURNS
    {{-0.9612, -4.1519, -0.0563, -1.8290, -4.1384, 10.9538, -3.9349, -1.3893, -1.4601, -0.8531}}, // NORMALS_3_TURNS
    {{-1.7673, -1.1390, -1.0818, 1.8423, -1.8630, -1.2577, 1.9029, 0.0429, 1.0031, -0.2130}}, // SMOOTHED_3_TURNS
    {{-0.4668, 2.9562, 2.2321, 1.5351, 0.4689, -1.8746, -1.8961, 4.0166, -5.0023, -2.5660}}, // SMOOTHED_4_TURNS
    {{0.1526, -1.0830, -1.0991, -0.6579, 0.6214, -1.8305, 0.5012, 0.1889, 5.3642, -1.2971}}, // GENTLY_4_TURNS
    {{-1.9016, -0.1786, -0.9173, 0.1986, 2.0130, 0.2305, 0.6859, -1.1467, -0.3328, 0.1120}}, // BARELY_4_TURNS
    {{3.2752, 5.1025, -0.4923, -0.7566, -1.8017, -3.1712, -1.7061, -1.0797, -1.0630, -1.8322}}, // EXACT_2_EXACT_3
    {{1.2699, -1.7487, 3.1465, 1.4533, -0.2907, 1.2700, -1.3074, 0.8284, 0.6316, -1.7150}}, // POINTS_2_POINTS_3
    {{-0.4433, -0.0849, -0.1603, -0.3235, 2.5592, -2.7975, -0.6710, -1.4394, -2.2655, 2.4412}}, // POINTS_3_POINTS_4
    {{-0.6668, -1.4716, 0.6110, 1.5652, -0.7253, -2.1922, -0.7668, 1.2906, -0.1633, 0.5845}}, // EXACT_3_POINTS_3
    {{-0.6283, -0.5756, -2.2801, -0.8634, -0.7537, 6.7790, -0.7211, -0.8650, 0.7138, -2.0226}}, // EXACT_3_NORMALS_3
    {{-1.1890, 1.3820, 1.7629, 1.0605, -1.4999, 1.4403, -0.6956, -1.8214, -0.3710, -0.2288}}, // POINTS_3_NORMALS_3
    {{0.4187, -0.2339, -0.0605, 1.5912, 0.5999, -2.2300, 0.7199, -1.5678, -1.7100, 0.5944}}, // POINTS_3_SMOOTHED_3
    {{0.2935, -0.3602, -1.9034, -0.3918, 0.8163, -0.5012, 0.2884, 2.0829, 3.3381, -1.1256}}, // POINTS_4_SMOOTHED_4
    {{-0.2093, -1.3038, 0.6234, -0.0548, 0.9748, -0.9519, -0.0693, 0.9204, 0.4866, -0.8486}}, // NORMALS_3_SMOOTHED_3
    {{-0.3421, -1.1813, -0.5546, -4.0220, -0.8557, 1.1813, 0.8242, 4.3373, 2.6646, 0.5175}}, // SMOOTHED_3_SMOOTHED_4
    {{-0.3872, -1.0847, -0.4920, 0.0426, -1.2942, -0.6931, 1.3872, -0.6090, 2.9117, 1.3278}}, // SMOOTHED_3_GENTLY_4
    {{0.5407, 0.6295, 0.4063, -0.4741, 0.4344, -0.5297, 0.0620, 0.2035, -2.1433, -0.3226}}, // SMOOTHED_4_GENTLY_4
    {{-1.2043, 0.5773, -1.7571, -0.2962, 0.9938, -1.5769, 1.1344, -1.8799, -2.4575, 3.0728}}, // GENTLY_4_BARELY_4
    {{-0.0928, -0.0311, -0.1832, -0.2405, 0.5924, 2.0958, 0.9481, -2.0054, -1.8533, -0.6470}}, // POINTS_4_BARELY_4
    {{-1.4525, 0.6767, 0.4317, 1.9370, 1.5042, -1.6586, -0.5592, -1.6658, -1.5188, 0.0980}}, // POINTS_3_NORMALS
    {{-0.1855, -1.1289, -0.3604, -2.1801, -3.2390, 2.7366, -0.6168, 1.8611, 0.9273, -0.8266}}, // SMOOTHED_3_NORMALS
    {{0.7282, -1.0359, -3.7465, -4.6819, -2.0267, 0.2589, 1.7654, 3.1239, 5.4561, -0.9317}}, // POINTS_3_BEND
    {{2.5222, 2.4586, 4.0793, 1.6953, 1.7698, -3.0888, -1.2394, -1.5619, -5.7206, -1.5001}}, // SMOOTHED_3_BEND
    {{-0.7448, 0.2896, -0.0776, -2.3152, -1.8673, -1.2057, 0.7280, -0.0265, 3.1819, 1.1270}}, // SMOOTHED_3_MOVES
    {{-0.0324, 0.0011, 0.1771, -0.0325, 0.1586, -0.1026, 0.0346, 0.2169, 0.0171, -0.2567}}, // SMOOTHED_3_DRIFT
    {{-0.0492, -0.1552, 1.3570, -0.9614, 0.7776, -2.2129, 0.1807, 1.5772, -1.5533, -0.3185}}, // NOISE
    {{3.7631, -0.7463, 2.2588, -2.7172, 0.5016, -3.4290, 0.2148, -1.3569, -1.3213, 0.2297}}}}; // IRREGULARITY
// clang-format on

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H
