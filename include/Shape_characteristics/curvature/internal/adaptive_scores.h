#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H

#include <Shape_characteristics/curvature/internal/Adaptive_statistics.h>

#include <array>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// The constants of adaptive_curvatures(), learned from surfaces whose curvature is known. Not written by hand: they are the
// output of
//   benchmark_adaptive_adaptive --calibrate adaptive_scores.h --keep
// as for CHECKED_2_RINGS and CHECKED_3_RINGS; the others, and the exactness, are of an earlier one without --keep.

// where EXACT_3_ANGLES - POINTS_3_ANGLES is less, EXACT_3_RINGS is chosen
inline constexpr double adaptive_exactness = -1.3000;

// Elsewhere the estimators are blended in proportion to exp(-score): a linear function of these statistics.
// clang-format off
inline constexpr std::array<Adaptive_statistic, 55> adaptive_score_statistics = {{
    Adaptive_statistic::EXACT_2_ANGLES,
    Adaptive_statistic::EXACT_3_ANGLES,
    Adaptive_statistic::POINTS_2_ANGLES,
    Adaptive_statistic::POINTS_3_ANGLES,
    Adaptive_statistic::POINTS_4_ANGLES,
    Adaptive_statistic::NORMALS_2_ANGLES,
    Adaptive_statistic::NORMALS_3_ANGLES,
    Adaptive_statistic::SMOOTHED_3_ANGLES,
    Adaptive_statistic::SMOOTHED_4_ANGLES,
    Adaptive_statistic::GENTLY_4_ANGLES,
    Adaptive_statistic::BARELY_4_ANGLES,
    Adaptive_statistic::CHECKED_2_ANGLES,
    Adaptive_statistic::CHECKED_3_ANGLES,
    Adaptive_statistic::EXACT_2_TURNS,
    Adaptive_statistic::EXACT_3_TURNS,
    Adaptive_statistic::POINTS_2_TURNS,
    Adaptive_statistic::POINTS_3_TURNS,
    Adaptive_statistic::POINTS_4_TURNS,
    Adaptive_statistic::NORMALS_2_TURNS,
    Adaptive_statistic::NORMALS_3_TURNS,
    Adaptive_statistic::SMOOTHED_3_TURNS,
    Adaptive_statistic::SMOOTHED_4_TURNS,
    Adaptive_statistic::GENTLY_4_TURNS,
    Adaptive_statistic::BARELY_4_TURNS,
    Adaptive_statistic::CHECKED_2_TURNS,
    Adaptive_statistic::CHECKED_3_TURNS,
    Adaptive_statistic::EXACT_2_EXACT_3,
    Adaptive_statistic::POINTS_2_POINTS_3,
    Adaptive_statistic::POINTS_3_POINTS_4,
    Adaptive_statistic::EXACT_3_POINTS_3,
    Adaptive_statistic::EXACT_2_NORMALS_2,
    Adaptive_statistic::NORMALS_2_NORMALS_3,
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
    Adaptive_statistic::CHECKED_2_CHECKED_3,
    Adaptive_statistic::CHECKED_3_POINTS_3,
    Adaptive_statistic::CHECKED_2_NORMALS_2,
    Adaptive_statistic::CHECKED_3_NORMALS_3,
    Adaptive_statistic::EXACT_3_CHECKED_3,
    Adaptive_statistic::POINTS_3_NORMALS,
    Adaptive_statistic::SMOOTHED_3_NORMALS,
    Adaptive_statistic::POINTS_3_BEND,
    Adaptive_statistic::SMOOTHED_3_BEND,
    Adaptive_statistic::SMOOTHED_3_MOVES,
    Adaptive_statistic::SMOOTHED_3_DRIFT,
    Adaptive_statistic::NOISE,
    Adaptive_statistic::IRREGULARITY}};
inline constexpr std::array<std::array<double, number_of_adaptive_candidates>, 56> adaptive_score_weights = {{
    {{1.7828, -2.4278, -9.5235, -10.2373, -0.6596, -8.3286, -3.4737, -9.9656, 1.1424, -5.1929, -9.8105, -3.6408, 2.2865}}, // 1
    {{0.2283, 4.5712, 1.1930, -2.2301, -0.4651, 0.9127, -1.3370, -1.5423, -0.7513, -2.4303, -0.9026, 2.5700, -0.4606}}, // EXACT_2_ANGLES
    {{0.2876, 5.1934, 1.6636, 1.4138, 0.4764, 0.6384, -2.2288, -1.5479, -3.4397, -1.7401, -0.5578, 2.6898, -0.8541}}, // EXACT_3_ANGLES
    {{0.5315, -2.1209, 3.9180, 0.4368, 2.8281, -1.5679, -0.6045, -2.1184, -1.7958, -1.6404, 0.4424, -2.1218, -1.2245}}, // POINTS_2_ANGLES
    {{0.3397, -1.1130, -1.9376, 4.1399, -2.0119, 0.6601, 0.9677, -0.8713, 0.6230, 0.3736, 1.0645, 0.4404, 0.8562}}, // POINTS_3_ANGLES
    {{0.4093, -1.6277, -2.7131, -1.0695, 7.3963, -0.3570, -1.4741, 0.4909, -2.2157, -3.1142, -2.8138, -0.0421, -1.1956}}, // POINTS_4_ANGLES
    {{0.1394, -0.9800, 0.3871, -0.2065, 0.9775, 2.5790, -1.3233, -1.1884, 0.2175, 0.1624, -1.1359, 1.5949, -1.1630}}, // NORMALS_2_ANGLES
    {{0.5428, 1.7241, -0.4487, -0.6195, -0.4298, -2.0093, 1.9873, 0.9432, -0.4047, -0.9479, -0.5730, -2.2228, 1.2475}}, // NORMALS_3_ANGLES
    {{0.2677, -0.6835, -1.7916, 0.4232, -0.2616, -1.0826, -0.1012, 2.0662, -0.4529, 1.8625, 0.4225, -1.7343, -0.4966}}, // SMOOTHED_3_ANGLES
    {{-0.3735, -5.4612, -5.1048, -3.0441, -5.9855, -0.0945, 2.4120, 0.8851, 6.0249, 5.0877, -1.0960, -2.0737, 1.3008}}, // SMOOTHED_4_ANGLES
    {{0.1144, -2.0469, -2.5880, 0.1713, -1.3607, -0.0674, 1.3350, -0.0543, 0.2371, 1.5410, 4.2348, -1.6066, 1.4494}}, // GENTLY_4_ANGLES
    {{0.1820, 0.8882, -0.3037, -3.4795, -1.2925, -0.8316, -0.3136, -0.9929, -0.3361, 1.2515, 5.0446, -1.4765, -0.0836}}, // BARELY_4_ANGLES
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 1.9894, 1.7569}}, // CHECKED_2_ANGLES
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 2.1173, 1.8654}}, // CHECKED_3_ANGLES
    {{-0.8516, -0.4756, 0.4561, -0.3904, -0.9689, -4.1775, -0.7613, 1.7507, 1.4818, 1.5618, 0.8112, -4.8021, -1.9135}}, // EXACT_2_TURNS
    {{-0.6684, 2.9797, -0.8420, -0.8161, -0.2755, 4.1476, -0.5897, 0.5439, -2.2027, -1.1081, -2.4091, 4.1428, -1.2881}}, // EXACT_3_TURNS
    {{-0.4512, -1.6783, 3.9734, -1.2086, 1.3835, -0.1286, -0.6904, -1.7535, 0.1054, 0.0487, -1.6757, -0.8437, -1.2242}}, // POINTS_2_TURNS
    {{-0.5237, 1.6261, -0.6105, 3.1467, -3.2690, -0.9268, -0.6184, 2.6392, -0.1701, -0.3162, -0.3406, -0.3636, -0.4926}}, // POINTS_3_TURNS
    {{-0.2964, 0.3148, -0.1063, -1.1150, 0.3940, -0.1585, 0.5625, -1.0599, 0.6844, 0.0874, -0.9512, 0.1458, 0.7445}}, // POINTS_4_TURNS
    {{-0.7275, -1.7216, -0.8891, 0.7870, -2.3442, 5.2080, 2.0110, -2.9196, 1.0862, -3.1092, -0.5904, 3.1742, 0.6353}}, // NORMALS_2_TURNS
    {{-0.5407, 1.0003, 2.9878, 1.4918, 1.9226, -6.4726, 6.2343, 0.3920, -1.1536, 2.2114, 1.5126, -5.1925, 4.9025}}, // NORMALS_3_TURNS
    {{-0.0695, -0.8535, -0.8179, 0.9952, 0.4193, 0.2679, -0.6902, -0.4019, 1.8132, -0.6010, -1.0991, 1.3588, -0.8267}}, // SMOOTHED_3_TURNS
    {{-0.1082, 0.4900, 0.2266, 1.7236, 0.7360, 0.0792, -0.7071, 0.6086, 2.2379, -5.3416, 0.3366, -0.1781, 0.1315}}, // SMOOTHED_4_TURNS
    {{0.1731, -1.7792, -2.0688, -1.1167, -1.0625, -1.2468, -2.0300, -2.9787, -1.1769, 7.8396, -0.9993, -1.6848, -1.8960}}, // GENTLY_4_TURNS
    {{-0.3520, -0.9391, 1.1422, -0.8159, 1.6476, 1.7401, -1.2973, 1.1638, -0.8513, -1.3101, 1.8458, 2.1658, -0.6686}}, // BARELY_4_TURNS
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.5172, -0.6410}}, // CHECKED_2_TURNS
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, -0.4124, -0.7406}}, // CHECKED_3_TURNS
    {{1.3705, 5.5140, -0.5766, -1.7209, -1.4285, -3.1299, -1.0605, -2.7301, -0.7821, -0.5004, -1.4330, -2.0543, -0.4488}}, // EXACT_2_EXACT_3
    {{0.4001, -1.8595, 2.4908, 1.8019, 0.4750, -0.9860, 0.1941, 0.0643, -0.9984, -1.2875, -0.5186, -1.1685, -0.1944}}, // POINTS_2_POINTS_3
    {{0.0127, 0.8315, 2.0484, -0.5916, 2.9106, -1.3962, -0.2509, -2.8350, -0.6633, -1.7487, -0.7326, -0.3716, -0.4157}}, // POINTS_3_POINTS_4
    {{-0.0380, -0.6833, 0.1672, 3.7952, -0.0035, -3.4919, 0.3854, -0.3245, -0.2189, -0.8942, 4.1912, -1.5766, 0.8306}}, // EXACT_3_POINTS_3
    {{-0.0934, 2.4903, -1.1197, 0.9661, 0.4783, 0.5255, -1.9501, -0.0439, -1.2901, -0.7514, -1.2658, -0.2086, -1.6697}}, // EXACT_2_NORMALS_2
    {{-0.0510, -4.5027, -0.8464, 0.4300, -0.4955, 7.8882, 3.1236, -0.2859, -2.3427, -2.1528, -0.4654, 4.5131, 1.4499}}, // NORMALS_2_NORMALS_3
    {{-0.1725, -2.7405, -1.8616, -3.8508, -0.1536, 4.1345, 1.9210, 0.4083, 1.9754, 1.8317, -1.1604, 3.2498, 1.9230}}, // EXACT_3_NORMALS_3
    {{-0.2226, 1.0417, -0.0838, -0.2023, -2.0627, 3.7619, -2.5247, 1.8270, -0.9980, 0.2286, 1.0269, 3.7846, -3.2512}}, // POINTS_3_NORMALS_3
    {{-0.0808, 0.5345, -0.0982, -0.0551, -0.7660, -1.3786, 0.2491, -0.8199, -0.5268, 1.0112, 2.2330, -1.6141, 1.1029}}, // POINTS_3_SMOOTHED_3
    {{-1.2271, -1.2516, -3.4289, -3.6990, -5.5672, 0.9862, -0.4798, 6.3723, 2.8671, 5.5483, 1.8404, -0.5854, -1.1658}}, // POINTS_4_SMOOTHED_4
    {{-0.2669, -0.4864, 0.3523, 1.9151, 1.6180, -0.8514, -0.0213, -0.3517, 0.3092, 0.0838, -2.7220, -0.4570, -1.1655}}, // NORMALS_3_SMOOTHED_3
    {{-1.1552, 2.1056, 0.9939, 0.8930, 1.4562, -2.5415, -0.8568, -2.8887, 2.3944, -0.7836, -0.5475, -1.2665, -1.1018}}, // SMOOTHED_3_SMOOTHED_4
    {{1.0850, -0.6775, -0.3559, -0.6972, -3.0942, 0.3101, 0.2620, 1.6505, 0.8463, 1.7306, -0.1771, 0.6009, -0.1788}}, // SMOOTHED_3_GENTLY_4
    {{-1.2455, -0.1009, -0.0700, -1.6272, 0.9060, 1.1065, 0.0212, 1.0137, 1.9240, -0.8437, -3.2252, 0.7278, -0.8790}}, // SMOOTHED_4_GENTLY_4
    {{0.1654, 0.2574, -0.0852, 1.5778, 1.4559, -0.9762, -0.4785, -2.1952, -1.9728, -0.5324, 2.3091, 0.1479, -1.6187}}, // GENTLY_4_BARELY_4
    {{0.0333, 0.0202, 0.2486, 3.6357, 2.8568, -1.3066, -0.6584, -1.9094, -2.2883, -2.8595, 0.7770, -1.2862, -0.4406}}, // POINTS_4_BARELY_4
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 5.3927, 3.8577}}, // CHECKED_2_CHECKED_3
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, -0.0691, -1.0444}}, // CHECKED_3_POINTS_3
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.9311, 1.0614}}, // CHECKED_2_NORMALS_2
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, -5.9057, -0.1498}}, // CHECKED_3_NORMALS_3
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, -0.6854, 1.7393}}, // EXACT_3_CHECKED_3
    {{0.1519, -0.4944, -0.0866, 1.0831, 1.2747, 1.2126, 0.8325, -3.7766, 0.2322, 0.1277, 1.2760, 2.6260, 0.3054}}, // POINTS_3_NORMALS
    {{-0.1231, -1.8196, 1.6243, -2.7222, -2.8813, -2.0645, 1.3431, 5.0774, 0.8538, 0.1475, -1.8352, -3.1423, 0.3625}}, // SMOOTHED_3_NORMALS
    {{0.5258, -1.7646, -1.2503, -2.5908, -1.0712, -1.1754, 0.6232, 0.9828, 1.7770, 1.6318, 2.0714, -2.2595, -0.0227}}, // POINTS_3_BEND
    {{1.5842, 2.7487, 2.9319, -1.4445, 0.2690, 1.3985, -2.1801, 0.0073, -0.9046, -2.4224, -2.8513, 1.2202, -1.8445}}, // SMOOTHED_3_BEND
    {{-0.0433, 1.2976, -1.5367, -2.5967, -0.0885, -1.1342, -0.0089, 3.5052, -0.0562, 2.1833, -1.6087, -1.0801, 0.6565}}, // SMOOTHED_3_MOVES
    {{0.3094, 0.0756, 0.2344, -0.4163, -0.2118, 0.0615, -0.2548, -0.2061, 0.4381, 0.0669, -0.0933, -0.2789, 0.3263}}, // SMOOTHED_3_DRIFT
    {{-0.4643, -0.3119, 0.6780, 0.6834, 1.4038, -0.3760, -1.2955, -0.0709, 2.1523, -1.6776, -2.8563, -0.1695, -0.2452}}, // NOISE
    {{-0.8272, -0.5946, 2.2007, -0.2781, 0.4352, 0.1087, -1.4052, 2.6316, 0.0844, -1.0545, -1.6413, -0.6612, -0.4912}}}}; // IRREGULARITY
// clang-format on

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H
