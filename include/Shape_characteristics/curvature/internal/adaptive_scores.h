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
    {{3.3252, -4.2187, 3.0020, -10.1944, -1.2520, -5.8817, -8.7140, 1.9097}}, // 1
    {{0.1400, 4.4902, -0.1038, -1.8439, 0.6591, -1.9963, -0.6788, -0.4487}}, // EXACT_2_ANGLES
    {{0.1517, 4.2548, -0.0944, -1.0814, -0.2023, -1.6989, -0.6840, -0.4241}}, // EXACT_3_ANGLES
    {{0.1012, -1.1262, 0.1256, 1.9404, 1.3773, -0.3698, -0.3038, -1.7244}}, // POINTS_2_ANGLES
    {{0.0388, -1.4555, 0.0148, 1.5075, -0.1693, -0.3630, 0.4588, 0.1396}}, // POINTS_3_ANGLES
    {{0.0709, -1.2951, 0.0005, -0.0250, 2.7507, -0.3704, 0.4918, -2.1296}}, // POINTS_4_ANGLES
    {{0.0375, -1.9632, 0.0863, -0.9528, -0.7425, 4.0668, -0.9215, -1.4888}}, // NORMALS_3_ANGLES
    {{0.0880, 0.1724, 0.0724, -0.3774, -0.5856, -0.5516, 0.3047, 1.0494}}, // SMOOTHED_3_ANGLES
    {{0.0897, 0.3754, 0.0692, -1.3614, -1.2373, -0.6157, 0.3566, 2.2617}}, // SMOOTHED_4_ANGLES
    {{-0.3478, -1.1082, -0.1924, 1.3407, 1.0055, -0.2901, -1.8012, 1.8027}}, // EXACT_2_TURNS
    {{-0.4244, -0.6814, -0.1701, 0.5694, -0.2763, 3.3257, -2.4185, -0.8865}}, // EXACT_3_TURNS
    {{0.0188, 0.1797, 0.1276, 0.7319, 0.5311, 0.0916, -1.2748, -0.5213}}, // POINTS_2_TURNS
    {{-0.1359, -1.7251, -0.0953, 1.8809, 0.1868, -0.4036, 0.8273, -0.3490}}, // POINTS_3_TURNS
    {{-0.0229, 0.8074, -0.1153, -1.4517, 2.6345, -0.8847, -0.5382, -1.0984}}, // POINTS_4_TURNS
    {{-0.2206, -2.1397, -0.0400, -1.7447, -3.5509, 7.2143, -1.5576, -2.6292}}, // NORMALS_3_TURNS
    {{0.0699, -1.0322, 0.0952, -0.5800, -1.2914, -1.8073, 1.6934, 2.4948}}, // SMOOTHED_3_TURNS
    {{0.2012, 1.3129, 0.1804, 0.3697, -3.1517, -0.8145, -1.0242, 2.6111}}, // SMOOTHED_4_TURNS
    {{0.2707, 3.8007, -0.1084, -2.4089, -0.8664, -2.0541, 0.2539, 0.1430}}, // EXACT_2_EXACT_3
    {{0.0743, -1.1351, 0.1860, 2.2515, 1.4987, -0.8655, -0.5439, -1.2545}}, // POINTS_2_POINTS_3
    {{0.0535, 0.3189, 0.0535, 1.6709, 0.9967, -1.2735, -0.3149, -1.1033}}, // POINTS_3_POINTS_4
    {{-0.0788, 0.6913, -0.1337, 0.2091, -0.7501, -0.0580, -0.4636, 0.3070}}, // EXACT_3_POINTS_3
    {{-0.0714, 1.0857, -0.1347, -0.3664, -1.1550, 2.1831, -0.9089, -1.7006}}, // EXACT_3_NORMALS_3
    {{0.0201, -0.0421, 0.0296, 1.7103, 0.3892, -0.8456, -0.4490, -0.4893}}, // POINTS_3_NORMALS_3
    {{0.1113, 0.6990, 0.0792, -0.0186, -0.4455, -0.6503, 0.2468, 0.2349}}, // POINTS_3_SMOOTHED_3
    {{0.0651, 0.0496, 0.0559, -0.2061, 1.8759, -0.8808, 0.3542, -1.5883}}, // POINTS_4_SMOOTHED_4
    {{-0.0779, -2.3173, 0.0380, -1.1184, 1.2075, 0.9760, 0.4506, 0.3630}}, // NORMALS_3_SMOOTHED_3
    {{0.0155, -1.3401, 0.0896, -1.7373, -1.5034, -2.0640, 1.2972, 4.7483}}, // SMOOTHED_3_SMOOTHED_4
    {{-0.0894, -0.4954, -0.1764, 1.7043, -0.9798, 0.4318, -0.8400, 0.1425}}, // POINTS_3_NORMALS
    {{-0.2502, -2.8034, -0.1567, 0.9697, -1.1793, 3.5159, -0.0699, -1.4840}}, // SMOOTHED_3_NORMALS
    {{-0.5422, -2.0682, -0.2088, -9.6725, 3.4815, -0.0794, 4.8756, 3.1813}}, // POINTS_3_BEND
    {{0.6482, 2.4278, 0.3261, 2.7343, 1.4968, -3.6555, -2.9187, -1.0954}}, // SMOOTHED_3_BEND
    {{0.0954, 1.1957, 0.0852, -2.0619, -0.4448, -1.1929, 0.5079, 1.7820}}, // SMOOTHED_3_MOVES
    {{0.1111, 0.4362, 0.1047, -0.3503, 0.0416, -0.4418, -0.1384, 0.3533}}, // SMOOTHED_3_DRIFT
    {{0.0238, -1.0187, 0.1631, 0.7518, 1.8596, -1.1967, -0.5546, 0.6953}}, // NOISE
    {{0.9119, -1.1324, 0.9025, -1.8699, 2.8361, -4.9881, 0.6894, 1.4038}}}}; // IRREGULARITY
// clang-format on

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H
