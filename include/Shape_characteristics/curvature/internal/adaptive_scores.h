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
    {{-4.0188, -2.5947, -6.5808, -7.5823, -1.0857, -7.9471, -10.8346, 1.9877, 0.3304, -9.4819}}, // 1
    {{2.4120, 3.6994, 0.0980, -2.3007, -0.0739, -1.8020, -0.7765, -0.3295, -2.0578, -0.5115}}, // EXACT_2_ANGLES
    {{0.6849, 2.8301, 2.3808, 1.0336, 0.4139, -3.3607, -1.4349, -2.1445, -1.6149, -0.1208}}, // EXACT_3_ANGLES
    {{-0.0808, -1.2115, 4.2374, 1.6703, 1.7371, -0.9378, -2.8658, -3.5320, -1.7679, -0.0120}}, // POINTS_2_ANGLES
    {{0.8738, -1.5306, -2.1664, 2.9305, -1.3282, -0.0522, 1.1389, 0.5672, 0.8046, 1.1510}}, // POINTS_3_ANGLES
    {{-0.5612, -2.0066, -2.1316, 0.4041, 7.0196, -2.2364, -1.3237, -1.4418, -1.3900, -0.5547}}, // POINTS_4_ANGLES
    {{0.8014, -0.4940, -0.3297, 0.4547, 0.3451, 2.1823, -1.5891, 0.2996, 0.0028, -1.3178}}, // NORMALS_3_ANGLES
    {{-0.9281, -0.3044, -0.8063, 0.7433, -0.4231, 0.3427, 1.0433, -0.1879, -0.6784, 1.1127}}, // SMOOTHED_3_ANGLES
    {{-1.7709, -2.7109, -3.3093, -1.3982, -3.4108, 1.7180, 0.0925, 7.9349, 4.4309, -2.2356}}, // SMOOTHED_4_ANGLES
    {{-0.6174, 0.4358, -1.3070, 0.1318, -0.4946, 1.2486, -0.0760, -0.9503, 2.0428, 0.1869}}, // GENTLY_4_ANGLES
    {{0.2675, 0.7878, 0.0017, -1.4984, -1.7688, -1.0241, -0.1437, -0.0020, 0.2247, 3.0111}}, // BARELY_4_ANGLES
    {{2.8887, -1.1282, -0.3796, 0.9662, -0.4167, -3.1769, 0.8949, 0.8426, 1.5698, 0.1382}}, // EXACT_2_TURNS
    {{1.2589, 4.2369, -1.7220, -1.2261, 0.5311, 4.3699, -2.3001, -3.0055, -1.6291, -0.6531}}, // EXACT_3_TURNS
    {{0.4366, -2.8709, 2.9271, -0.8478, 0.9120, -0.3193, -0.8776, 0.3740, -0.4924, -0.2453}}, // POINTS_2_TURNS
    {{0.1915, 0.4340, -1.2654, 3.0244, -3.0980, 0.5109, 1.1986, 0.3521, 0.2359, 0.0787}}, // POINTS_3_TURNS
    {{0.1683, 0.4676, 0.6864, -0.9322, 0.5807, 0.0478, -0.9347, 0.3183, -0.0246, -0.7005}}, // POINTS_4_TURNS
    {{-1.0219, -4.0681, -0.6327, -1.9879, -1.4107, 11.7577, -1.8004, -2.2022, -2.9125, -0.6327}}, // NORMALS_3_TURNS
    {{0.2588, -0.8895, -0.7044, 0.4257, -0.9157, -1.8177, 3.2385, -0.3057, -0.6386, 1.5935}}, // SMOOTHED_3_TURNS
    {{0.5260, 1.8697, 1.0487, 0.5422, 0.6338, -1.9305, -1.7459, 3.5089, -5.9414, -0.1639}}, // SMOOTHED_4_TURNS
    {{0.0420, -0.7029, -0.7326, -1.0183, 0.4268, -3.6382, -3.9371, -0.9513, 8.6345, -2.0726}}, // GENTLY_4_TURNS
    {{-0.6639, -0.0297, -0.9845, -0.3132, 1.3831, 0.1967, 1.3305, -1.0310, -0.8637, 1.9000}}, // BARELY_4_TURNS
    {{-1.4761, 5.6354, -0.2663, -0.6459, -0.9725, -2.8849, -2.3919, -0.0503, 0.3507, -1.3842}}, // EXACT_2_EXACT_3
    {{-0.2070, -0.9662, 3.2799, 0.0860, 0.3234, -0.3106, 0.4129, -1.1170, -1.3896, -0.7007}}, // POINTS_2_POINTS_3
    {{-0.0670, 0.6420, 0.6189, 0.5581, 1.7271, -1.5886, -2.0177, -1.1135, -2.2439, 1.1171}}, // POINTS_3_POINTS_4
    {{-1.1278, -2.5978, 0.1178, 1.0118, -0.4991, -1.6787, 1.4691, 1.5559, -0.0523, 2.3159}}, // EXACT_3_POINTS_3
    {{-0.9703, 0.7703, -1.2662, -0.5248, -0.1062, 6.4117, 0.5876, -0.9318, 0.1218, -1.3909}}, // EXACT_3_NORMALS_3
    {{0.6060, 1.3000, 1.6622, -0.1440, -0.8147, 0.4386, 0.2817, -1.4828, 0.3641, -0.7189}}, // POINTS_3_NORMALS_3
    {{-0.2749, 0.9180, -1.7584, 2.1339, 0.5950, -1.9369, -0.1470, -1.5963, -2.7052, 1.8876}}, // POINTS_3_SMOOTHED_3
    {{-1.8040, -2.4839, -2.1681, 0.2239, -5.5280, -0.4200, 5.3174, 2.1070, 4.8350, 3.3161}}, // POINTS_4_SMOOTHED_4
    {{1.0502, -2.0965, 0.8720, -0.9492, 0.6070, -1.4360, 1.2929, 1.1972, 0.6287, -0.7178}}, // NORMALS_3_SMOOTHED_3
    {{-0.9588, -0.8618, 1.2031, -5.4500, 0.1444, 0.4638, -1.8358, 0.9574, 7.1166, -1.4871}}, // SMOOTHED_3_SMOOTHED_4
    {{-0.4831, -1.0420, -0.6923, -0.4630, -1.7316, -1.3634, 3.5969, -0.0885, 2.6204, 2.3843}}, // SMOOTHED_3_GENTLY_4
    {{1.2717, 0.6096, 0.1151, 0.6393, 0.7228, 1.5956, -2.1815, 4.1932, -4.4274, -5.3086}}, // SMOOTHED_4_GENTLY_4
    {{-0.2510, 0.7537, 0.0991, 1.5851, 1.0139, -1.4601, -2.5903, -1.9783, -1.3105, 2.1359}}, // GENTLY_4_BARELY_4
    {{0.1593, 0.6079, -0.5381, 0.9426, 2.0747, 1.7101, -1.3284, -1.5093, -2.4069, -0.8199}}, // POINTS_4_BARELY_4
    {{-0.9091, 0.4463, -0.1296, 2.6418, 1.5844, -1.0680, -3.8626, -0.9253, -0.7738, 0.4831}}, // POINTS_3_NORMALS
    {{-0.5990, -1.9789, 1.4377, -3.2485, -3.3467, 4.6549, 5.8935, 0.8673, -0.5528, -0.6173}}, // SMOOTHED_3_NORMALS
    {{0.5461, -0.7061, -3.1628, -5.4361, -0.0712, 0.4279, 1.8444, 3.3583, 4.8367, -1.9422}}, // POINTS_3_BEND
    {{-1.6717, 2.5651, 3.0955, 4.7135, -0.2741, -2.8557, 0.0113, -1.2214, -5.6161, -0.5903}}, // SMOOTHED_3_BEND
    {{-1.1622, 0.7080, -1.3430, -1.5848, -0.2356, -0.1364, 2.9521, 1.9802, 2.6825, -1.3417}}, // SMOOTHED_3_MOVES
    {{0.2593, -0.1597, 0.2024, 0.0067, 0.0776, -0.0060, -0.2804, 0.2371, 0.0142, -1.0789}}, // SMOOTHED_3_DRIFT
    {{-0.3421, -0.0079, 0.9085, -0.7535, 0.6683, -2.5473, -0.0242, 0.6012, 0.5085, -0.3964}}, // NOISE
    {{-1.1790, 0.2420, 1.9955, -0.1064, 0.8208, -1.6685, 1.2600, -0.6498, -0.5202, 0.1016}}}}; // IRREGULARITY
// clang-format on

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H
