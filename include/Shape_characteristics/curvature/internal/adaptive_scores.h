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
    {{-9.6790, -6.2480, -8.9924, -11.2676, -5.6110, -12.9942, 5.2167, -3.2767, -10.0818, -6.9716}}, // 1
    {{0.3528, 3.8645, -0.0937, -1.6900, 0.3501, -1.2273, -1.3265, 0.0215, -1.4977, 0.1396}}, // EXACT_2_ANGLES
    {{0.4018, 2.9953, 2.1487, -0.0139, -0.1301, -3.6348, 0.8715, -1.3592, -2.1914, -0.0250}}, // EXACT_3_ANGLES
    {{-0.4264, -2.3100, 3.7273, 1.1183, 0.8738, -1.7365, 0.9347, -2.9011, -2.3607, 0.7043}}, // POINTS_2_ANGLES
    {{0.0183, -1.1968, -2.8478, 3.4978, -0.0842, -0.5594, 0.2081, 1.2515, 0.6173, 0.6327}}, // POINTS_3_ANGLES
    {{0.9455, -2.9846, -2.7073, -0.8805, 7.7572, -2.6702, 0.5238, -2.2329, -1.3525, 0.6430}}, // POINTS_4_ANGLES
    {{0.1183, -0.2039, -0.8582, -0.2198, 0.1809, 2.0319, 0.5196, -0.6153, -1.1552, -1.7781}}, // NORMALS_3_ANGLES
    {{-0.1166, -0.7838, -2.0095, 1.5308, -0.1995, 1.4683, 0.3019, 0.4326, -0.6968, 0.4836}}, // SMOOTHED_3_ANGLES
    {{0.2439, -0.7496, -2.2891, -2.0343, -0.5509, 0.4791, 0.2373, 3.0786, 3.1605, -0.4711}}, // SMOOTHED_4_ANGLES
    {{0.5871, -0.7487, -2.2165, -1.0004, -0.3186, 0.9388, 0.3758, 0.5232, 2.5435, 0.4244}}, // GENTLY_4_ANGLES
    {{-0.4206, 0.9514, 0.5674, -1.2973, -3.3342, -0.8528, 0.9987, 0.5688, 0.0377, 2.4257}}, // BARELY_4_ANGLES
    {{-0.7230, -1.8025, 0.0860, 0.6014, 0.2581, -3.0050, 1.4776, 0.5827, 0.4909, 0.7110}}, // EXACT_2_TURNS
    {{-0.9928, 3.8145, -1.3197, -2.3327, -0.1576, 3.2743, -1.0852, -3.8120, -1.3062, -0.8718}}, // EXACT_3_TURNS
    {{0.4071, -1.2586, 3.3525, -1.2890, 1.2585, 0.0210, -1.7824, 0.1762, 0.1069, 0.0075}}, // POINTS_2_TURNS
    {{-0.0443, 0.2518, -1.3222, 2.4379, -3.8872, 0.7137, 0.6427, 0.4341, 0.1780, 0.8840}}, // POINTS_3_TURNS
    {{0.9989, 0.8171, 1.4759, -0.5739, 0.9568, 0.5819, -1.2332, 0.5292, -0.0257, -0.8265}}, // POINTS_4_TURNS
    {{-1.4987, -4.8976, -0.5653, -1.1971, -3.6266, 11.0007, -3.9217, -1.6391, -1.5452, -1.1094}}, // NORMALS_3_TURNS
    {{-1.8685, -1.1760, -1.1683, 1.2510, -2.7391, -1.7861, 1.9479, -0.3752, 0.3554, 3.7672}}, // SMOOTHED_3_TURNS
    {{0.6333, 3.2263, 2.6107, 2.0536, 0.2967, -1.7148, -2.1049, 4.3181, -4.5076, -6.4877}}, // SMOOTHED_4_TURNS
    {{-0.3854, -0.9752, -0.8114, -0.2431, 0.2276, -1.7201, -0.0776, 0.1845, 5.7421, -1.9697}}, // GENTLY_4_TURNS
    {{-0.5350, -0.5092, -1.1830, -0.2726, 1.7480, 0.2336, 0.5454, -1.1813, -0.4597, 1.6185}}, // BARELY_4_TURNS
    {{3.2125, 4.8811, -1.4567, -1.0395, -1.4109, -2.9969, -1.2610, -1.0579, -1.0261, -1.2523}}, // EXACT_2_EXACT_3
    {{0.8779, -1.0222, 3.0270, 1.1295, -0.3909, 0.6608, -1.3323, 0.0294, -0.0404, -1.3195}}, // POINTS_2_POINTS_3
    {{-0.4717, -0.1400, -0.0275, -0.1063, 2.2017, -2.5319, -0.2645, -1.2963, -1.9987, 2.2305}}, // POINTS_3_POINTS_4
    {{-0.8590, -1.6158, 1.1257, 1.7455, -0.7265, -2.0924, -0.9836, 1.1917, -0.1870, 1.0258}}, // EXACT_3_POINTS_3
    {{-0.2715, -0.7618, -2.8381, -0.7777, -1.0947, 6.8477, -0.6861, -0.8467, 0.6593, -1.6436}}, // EXACT_3_NORMALS_3
    {{-1.0612, 1.8666, 1.5242, 1.2347, -1.2732, 1.0508, -0.6687, -2.1131, -0.9581, -0.6275}}, // POINTS_3_NORMALS_3
    {{0.7512, 0.2535, 0.4038, 1.4140, -0.4928, -2.2768, 0.8265, -1.5916, -1.4373, 0.9563}}, // POINTS_3_SMOOTHED_3
    {{0.1903, -0.5969, -2.0379, -0.7181, 1.4593, -1.0757, 0.3565, 1.7243, 2.6395, -1.3037}}, // POINTS_4_SMOOTHED_4
    {{-0.1261, -1.3921, 1.0553, 0.1918, 0.9341, -1.0268, -0.3729, 0.7943, 0.4453, -1.1629}}, // NORMALS_3_SMOOTHED_3
    {{-0.1830, -1.2520, -0.3958, -3.2410, -1.1523, 1.0238, 0.5601, 3.1351, 4.8110, 0.2020}}, // SMOOTHED_3_SMOOTHED_4
    {{-0.1860, -1.0248, -0.2790, 0.0298, -1.4075, -0.8094, 1.3178, -0.5066, 2.7237, 1.4980}}, // SMOOTHED_3_GENTLY_4
    {{0.9755, 0.9651, 0.7663, -0.6521, 0.8624, -0.3635, -0.3309, 1.3062, -4.2165, -0.8752}}, // SMOOTHED_4_GENTLY_4
    {{-1.5908, 0.6422, -1.5777, -0.0190, 0.6363, -1.3468, 1.4292, -1.5951, -2.0477, 3.4122}}, // GENTLY_4_BARELY_4
    {{-0.1982, -0.0064, -0.3278, -0.3632, 0.7081, 2.0790, 0.8435, -2.0490, -1.6154, -0.4619}}, // POINTS_4_BARELY_4
    {{-1.7506, 0.5049, 0.5418, 1.9727, 1.4990, -1.1488, -0.6807, -1.1821, -1.0579, -0.4225}}, // POINTS_3_NORMALS
    {{-0.0213, -1.0946, 0.1187, -1.3163, -3.5672, 3.0957, -0.8907, 2.2146, 1.1823, -1.8753}}, // SMOOTHED_3_NORMALS
    {{-0.4171, -0.9424, -4.2177, -5.1774, -0.3063, 0.5112, 2.1885, 3.1317, 5.2085, -0.5587}}, // POINTS_3_BEND
    {{1.7014, 2.7210, 3.1944, 1.1884, 2.0770, -3.4367, 0.2323, -1.7831, -5.8982, -0.2091}}, // SMOOTHED_3_BEND
    {{-1.1602, -0.3928, -0.3061, -2.3074, -0.9890, -0.3156, 0.8798, 0.4809, 3.3623, 0.8828}}, // SMOOTHED_3_MOVES
    {{0.1797, 0.0878, 0.3759, 0.2656, 0.0682, 0.0912, 0.6056, 0.4140, 0.1955, -2.0263}}, // SMOOTHED_3_DRIFT
    {{0.2461, 0.2531, 1.6326, -1.1720, 1.0169, -2.7581, -0.2095, 0.5667, -2.1485, 0.6366}}, // NOISE
    {{6.9485, -0.8551, 2.2713, -2.8130, 0.3826, -3.2294, -0.1394, -1.8199, -1.4561, -0.3920}}}}; // IRREGULARITY
// clang-format on

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H
