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
inline constexpr double adaptive_exactness = -1.5500;

// Elsewhere the estimator with the lowest score: the logarithm of the error that it predicts, up to a sum that is common to
// all, as a linear function of these statistics.
// clang-format off
inline constexpr std::array<Adaptive_statistic, 34> adaptive_score_statistics = {{
    Adaptive_statistic::EXACT_2_ANGLES,
    Adaptive_statistic::EXACT_3_ANGLES,
    Adaptive_statistic::POINTS_2_ANGLES,
    Adaptive_statistic::POINTS_3_ANGLES,
    Adaptive_statistic::POINTS_4_ANGLES,
    Adaptive_statistic::NORMALS_3_ANGLES,
    Adaptive_statistic::SMOOTHED_3_ANGLES,
    Adaptive_statistic::SMOOTHED_4_ANGLES,
    Adaptive_statistic::EXACT_2_TURNS,
    Adaptive_statistic::EXACT_3_TURNS,
    Adaptive_statistic::POINTS_2_TURNS,
    Adaptive_statistic::POINTS_3_TURNS,
    Adaptive_statistic::POINTS_4_TURNS,
    Adaptive_statistic::NORMALS_3_TURNS,
    Adaptive_statistic::SMOOTHED_3_TURNS,
    Adaptive_statistic::SMOOTHED_4_TURNS,
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
    Adaptive_statistic::POINTS_3_NORMALS,
    Adaptive_statistic::SMOOTHED_3_NORMALS,
    Adaptive_statistic::POINTS_3_BEND,
    Adaptive_statistic::SMOOTHED_3_BEND,
    Adaptive_statistic::SMOOTHED_3_MOVES,
    Adaptive_statistic::SMOOTHED_3_DRIFT,
    Adaptive_statistic::NOISE,
    Adaptive_statistic::IRREGULARITY}};
inline constexpr std::array<std::array<double, number_of_adaptive_candidates>, 35> adaptive_score_weights = {{
    {{3.3093, -4.3765, -8.4337, -8.9321, 3.4329, -3.4012, -12.3349, 4.7332}}, // 1
    {{0.2508, 4.4814, -0.1320, -1.8306, 0.2603, -2.2264, -1.0946, -0.1025}}, // EXACT_2_ANGLES
    {{0.2819, 4.4433, 0.2834, -1.2375, -0.4032, -1.9485, -1.3475, -0.3636}}, // EXACT_3_ANGLES
    {{0.0734, -3.0212, 4.0960, -0.0709, 1.8647, -0.4442, -0.6977, -0.8009}}, // POINTS_2_ANGLES
    {{0.0674, -2.1551, -2.9120, 3.7718, -0.0655, -0.5685, 0.2753, 1.0482}}, // POINTS_3_ANGLES
    {{0.0900, -2.1875, -2.3365, 2.8867, 2.1658, 0.2378, 0.7314, -2.1286}}, // POINTS_4_ANGLES
    {{0.0476, -1.4806, -0.5020, -1.1594, 0.6804, 4.9386, -1.2413, -1.0886}}, // NORMALS_3_ANGLES
    {{0.0813, -0.5351, -1.9393, -0.2542, 0.0104, -0.2484, 0.7192, 1.7689}}, // SMOOTHED_3_ANGLES
    {{0.1039, -0.3868, -0.8268, -1.6883, -1.2166, -0.4165, 0.7762, 3.0623}}, // SMOOTHED_4_ANGLES
    {{-0.2190, 0.3917, 0.4956, 0.5414, 0.4330, -0.4535, -2.1682, 0.8597}}, // EXACT_2_TURNS
    {{-0.3170, 0.4535, -0.2755, -0.0047, -0.7370, 4.1427, -3.0812, -0.8538}}, // EXACT_3_TURNS
    {{0.1022, -0.4182, 2.8128, -0.0535, 1.0574, 0.1929, -2.1400, -1.2333}}, // POINTS_2_TURNS
    {{0.0097, -0.0836, -1.9708, 2.5205, -0.0429, -0.7249, 0.3666, -0.4954}}, // POINTS_3_TURNS
    {{0.0429, 0.5254, -0.7099, -1.8041, 2.4493, -0.4317, -0.4043, -0.7104}}, // POINTS_4_TURNS
    {{-0.1554, -3.0523, -0.3704, -2.0706, -2.2783, 6.9074, -1.6266, -1.3045}}, // NORMALS_3_TURNS
    {{0.0983, -1.5037, -1.5432, -2.2530, -1.2112, -0.4031, 2.3738, 3.6287}}, // SMOOTHED_3_TURNS
    {{0.2681, 2.1561, -0.0193, 0.8444, -2.4059, -0.6492, -2.5958, 1.7649}}, // SMOOTHED_4_TURNS
    {{0.3269, 5.4387, -0.9108, -1.9362, -1.4766, -3.0615, -0.1159, -0.9717}}, // EXACT_2_EXACT_3
    {{-0.0159, -2.4554, 2.7692, 0.8788, 2.0179, -0.8631, -0.5587, -1.2676}}, // POINTS_2_POINTS_3
    {{-0.0100, 0.1177, 1.0984, 0.5804, 2.0039, -1.4622, -0.0960, -2.3273}}, // POINTS_3_POINTS_4
    {{-0.0934, -0.0706, 0.1547, 1.0993, -0.9989, -0.6408, 0.0908, 0.5006}}, // EXACT_3_POINTS_3
    {{-0.0280, 0.9545, -1.6134, 0.5233, -0.9595, 2.9178, -0.2911, -1.5792}}, // EXACT_3_NORMALS_3
    {{0.0290, 1.3986, 0.7571, 0.8021, 0.7331, -0.5910, -0.6031, -2.5377}}, // POINTS_3_NORMALS_3
    {{0.1296, 0.8306, -0.5191, -0.0392, -0.2935, -0.9617, 0.2127, 0.3860}}, // POINTS_3_SMOOTHED_3
    {{0.0294, -0.1574, 0.0188, -2.1708, 1.3551, -0.7614, 0.8205, 0.5530}}, // POINTS_4_SMOOTHED_4
    {{-0.1181, -2.1465, -0.1911, 0.0663, 0.3736, 0.5887, 0.8692, 0.8699}}, // NORMALS_3_SMOOTHED_3
    {{-0.0757, -0.3604, -0.9782, -2.7077, -0.5068, -1.8914, 1.9002, 3.6738}}, // SMOOTHED_3_SMOOTHED_4
    {{-0.0697, 0.1665, 0.3734, 1.8231, -1.0011, 0.2469, -1.2768, -0.4851}}, // POINTS_3_NORMALS
    {{-0.3839, -3.0227, 0.9903, -0.4653, -1.3187, 3.8617, 0.6419, -1.1123}}, // SMOOTHED_3_NORMALS
    {{-1.2047, -2.4139, -7.4507, -7.2796, 3.6790, 0.6363, 5.7177, 5.4494}}, // POINTS_3_BEND
    {{0.6017, 3.6572, 4.1599, 1.9750, 1.5373, -4.6557, -5.1305, -2.8287}}, // SMOOTHED_3_BEND
    {{0.0669, 0.4216, -1.6061, 0.2869, -1.0851, -1.2101, 0.7964, 1.6441}}, // SMOOTHED_3_MOVES
    {{0.0772, 0.4021, 0.5022, 0.1745, -0.4364, -0.5802, 0.0247, -0.0533}}, // SMOOTHED_3_DRIFT
    {{-0.0630, -0.0220, 1.4464, 0.0805, 1.4617, -1.8510, -0.9990, 0.4081}}, // NOISE
    {{0.4600, 2.6060, -0.7776, -0.5265, -0.9482, -5.0923, 2.6587, 0.7903}}}}; // IRREGULARITY
// clang-format on

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H
