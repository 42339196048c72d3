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

// where EXACT_3_ANGLES - POINTS_3_ANGLES is less, CHECKED_3_RINGS is chosen
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
    {{1.7828, -2.4278, -9.5235, -10.2373, -0.6596, -8.3286, -3.4737, -9.9656, 1.1424, -5.1929, -9.8105, -3.3502, -2.1402}}, // 1
    {{0.2283, 4.5712, 1.1930, -2.2301, -0.4651, 0.9127, -1.3370, -1.5423, -0.7513, -2.4303, -0.9026, 3.8750, 1.1245}}, // EXACT_2_ANGLES
    {{0.2876, 5.1934, 1.6636, 1.4138, 0.4764, 0.6384, -2.2288, -1.5479, -3.4397, -1.7401, -0.5578, 3.6642, 1.1757}}, // EXACT_3_ANGLES
    {{0.5315, -2.1209, 3.9180, 0.4368, 2.8281, -1.5679, -0.6045, -2.1184, -1.7958, -1.6404, 0.4424, -1.7848, -1.4010}}, // POINTS_2_ANGLES
    {{0.3397, -1.1130, -1.9376, 4.1399, -2.0119, 0.6601, 0.9677, -0.8713, 0.6230, 0.3736, 1.0645, 0.7942, 1.5480}}, // POINTS_3_ANGLES
    {{0.4093, -1.6277, -2.7131, -1.0695, 7.3963, -0.3570, -1.4741, 0.4909, -2.2157, -3.1142, -2.8138, -0.7387, -0.8916}}, // POINTS_4_ANGLES
    {{0.1394, -0.9800, 0.3871, -0.2065, 0.9775, 2.5790, -1.3233, -1.1884, 0.2175, 0.1624, -1.1359, 1.8790, 0.8391}}, // NORMALS_2_ANGLES
    {{0.5428, 1.7241, -0.4487, -0.6195, -0.4298, -2.0093, 1.9873, 0.9432, -0.4047, -0.9479, -0.5730, -3.2471, 0.2134}}, // NORMALS_3_ANGLES
    {{0.2677, -0.6835, -1.7916, 0.4232, -0.2616, -1.0826, -0.1012, 2.0662, -0.4529, 1.8625, 0.4225, -2.1808, -1.1599}}, // SMOOTHED_3_ANGLES
    {{-0.3735, -5.4612, -5.1048, -3.0441, -5.9855, -0.0945, 2.4120, 0.8851, 6.0249, 5.0877, -1.0960, -2.1552, -0.0837}}, // SMOOTHED_4_ANGLES
    {{0.1144, -2.0469, -2.5880, 0.1713, -1.3607, -0.0674, 1.3350, -0.0543, 0.2371, 1.5410, 4.2348, -1.3994, 0.7430}}, // GENTLY_4_ANGLES
    {{0.1820, 0.8882, -0.3037, -3.4795, -1.2925, -0.8316, -0.3136, -0.9929, -0.3361, 1.2515, 5.0446, -1.3301, -1.2392}}, // BARELY_4_ANGLES
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 1.2878, 0.6538}}, // CHECKED_2_ANGLES
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.7724, 0.1231}}, // CHECKED_3_ANGLES
    {{-0.8516, -0.4756, 0.4561, -0.3904, -0.9689, -4.1775, -0.7613, 1.7507, 1.4818, 1.5618, 0.8112, -4.7549, -2.1839}}, // EXACT_2_TURNS
    {{-0.6684, 2.9797, -0.8420, -0.8161, -0.2755, 4.1476, -0.5897, 0.5439, -2.2027, -1.1081, -2.4091, 4.7240, 0.2604}}, // EXACT_3_TURNS
    {{-0.4512, -1.6783, 3.9734, -1.2086, 1.3835, -0.1286, -0.6904, -1.7535, 0.1054, 0.0487, -1.6757, -1.2731, -0.6965}}, // POINTS_2_TURNS
    {{-0.5237, 1.6261, -0.6105, 3.1467, -3.2690, -0.9268, -0.6184, 2.6392, -0.1701, -0.3162, -0.3406, -0.4721, -0.9491}}, // POINTS_3_TURNS
    {{-0.2964, 0.3148, -0.1063, -1.1150, 0.3940, -0.1585, 0.5625, -1.0599, 0.6844, 0.0874, -0.9512, 0.5352, 0.2383}}, // POINTS_4_TURNS
    {{-0.7275, -1.7216, -0.8891, 0.7870, -2.3442, 5.2080, 2.0110, -2.9196, 1.0862, -3.1092, -0.5904, 3.1113, -0.3838}}, // NORMALS_2_TURNS
    {{-0.5407, 1.0003, 2.9878, 1.4918, 1.9226, -6.4726, 6.2343, 0.3920, -1.1536, 2.2114, 1.5126, -7.2878, 2.5014}}, // NORMALS_3_TURNS
    {{-0.0695, -0.8535, -0.8179, 0.9952, 0.4193, 0.2679, -0.6902, -0.4019, 1.8132, -0.6010, -1.0991, 0.7221, 0.3028}}, // SMOOTHED_3_TURNS
    {{-0.1082, 0.4900, 0.2266, 1.7236, 0.7360, 0.0792, -0.7071, 0.6086, 2.2379, -5.3416, 0.3366, -0.2016, -1.7754}}, // SMOOTHED_4_TURNS
    {{0.1731, -1.7792, -2.0688, -1.1167, -1.0625, -1.2468, -2.0300, -2.9787, -1.1769, 7.8396, -0.9993, -1.4875, -1.6102}}, // GENTLY_4_TURNS
    {{-0.3520, -0.9391, 1.1422, -0.8159, 1.6476, 1.7401, -1.2973, 1.1638, -0.8513, -1.3101, 1.8458, 2.4319, -1.3412}}, // BARELY_4_TURNS
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 1.2350, -1.0155}}, // CHECKED_2_TURNS
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, -0.4202, 4.3793}}, // CHECKED_3_TURNS
    {{1.3705, 5.5140, -0.5766, -1.7209, -1.4285, -3.1299, -1.0605, -2.7301, -0.7821, -0.5004, -1.4330, -3.2043, -2.2039}}, // EXACT_2_EXACT_3
    {{0.4001, -1.8595, 2.4908, 1.8019, 0.4750, -0.9860, 0.1941, 0.0643, -0.9984, -1.2875, -0.5186, -1.8352, -0.2160}}, // POINTS_2_POINTS_3
    {{0.0127, 0.8315, 2.0484, -0.5916, 2.9106, -1.3962, -0.2509, -2.8350, -0.6633, -1.7487, -0.7326, -1.0099, -0.3112}}, // POINTS_3_POINTS_4
    {{-0.0380, -0.6833, 0.1672, 3.7952, -0.0035, -3.4919, 0.3854, -0.3245, -0.2189, -0.8942, 4.1912, -2.3715, 1.0328}}, // EXACT_3_POINTS_3
    {{-0.0934, 2.4903, -1.1197, 0.9661, 0.4783, 0.5255, -1.9501, -0.0439, -1.2901, -0.7514, -1.2658, 0.5426, -1.9421}}, // EXACT_2_NORMALS_2
    {{-0.0510, -4.5027, -0.8464, 0.4300, -0.4955, 7.8882, 3.1236, -0.2859, -2.3427, -2.1528, -0.4654, 5.0399, 0.6873}}, // NORMALS_2_NORMALS_3
    {{-0.1725, -2.7405, -1.8616, -3.8508, -0.1536, 4.1345, 1.9210, 0.4083, 1.9754, 1.8317, -1.1604, 2.9712, 2.2262}}, // EXACT_3_NORMALS_3
    {{-0.2226, 1.0417, -0.0838, -0.2023, -2.0627, 3.7619, -2.5247, 1.8270, -0.9980, 0.2286, 1.0269, 3.7603, -0.8063}}, // POINTS_3_NORMALS_3
    {{-0.0808, 0.5345, -0.0982, -0.0551, -0.7660, -1.3786, 0.2491, -0.8199, -0.5268, 1.0112, 2.2330, -0.4786, 0.0802}}, // POINTS_3_SMOOTHED_3
    {{-1.2271, -1.2516, -3.4289, -3.6990, -5.5672, 0.9862, -0.4798, 6.3723, 2.8671, 5.5483, 1.8404, 1.3164, -0.5426}}, // POINTS_4_SMOOTHED_4
    {{-0.2669, -0.4864, 0.3523, 1.9151, 1.6180, -0.8514, -0.0213, -0.3517, 0.3092, 0.0838, -2.7220, -1.4571, -0.1017}}, // NORMALS_3_SMOOTHED_3
    {{-1.1552, 2.1056, 0.9939, 0.8930, 1.4562, -2.5415, -0.8568, -2.8887, 2.3944, -0.7836, -0.5475, -0.4775, -1.0920}}, // SMOOTHED_3_SMOOTHED_4
    {{1.0850, -0.6775, -0.3559, -0.6972, -3.0942, 0.3101, 0.2620, 1.6505, 0.8463, 1.7306, -0.1771, 0.4044, -0.9463}}, // SMOOTHED_3_GENTLY_4
    {{-1.2455, -0.1009, -0.0700, -1.6272, 0.9060, 1.1065, 0.0212, 1.0137, 1.9240, -0.8437, -3.2252, 0.8806, -0.5654}}, // SMOOTHED_4_GENTLY_4
    {{0.1654, 0.2574, -0.0852, 1.5778, 1.4559, -0.9762, -0.4785, -2.1952, -1.9728, -0.5324, 2.3091, -0.3330, -0.4839}}, // GENTLY_4_BARELY_4
    {{0.0333, 0.0202, 0.2486, 3.6357, 2.8568, -1.3066, -0.6584, -1.9094, -2.2883, -2.8595, 0.7770, -1.8692, -1.2962}}, // POINTS_4_BARELY_4
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 5.4186, 6.2321}}, // CHECKED_2_CHECKED_3
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, -1.9020, -2.2693}}, // CHECKED_3_POINTS_3
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 1.0104, -1.3873}}, // CHECKED_2_NORMALS_2
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, -3.3096, 2.0580}}, // CHECKED_3_NORMALS_3
    {{0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.1318, 2.3033}}, // EXACT_3_CHECKED_3
    {{0.1519, -0.4944, -0.0866, 1.0831, 1.2747, 1.2126, 0.8325, -3.7766, 0.2322, 0.1277, 1.2760, 2.7391, 1.8820}}, // POINTS_3_NORMALS
    {{-0.1231, -1.8196, 1.6243, -2.7222, -2.8813, -2.0645, 1.3431, 5.0774, 0.8538, 0.1475, -1.8352, -2.3021, -0.3344}}, // SMOOTHED_3_NORMALS
    {{0.5258, -1.7646, -1.2503, -2.5908, -1.0712, -1.1754, 0.6232, 0.9828, 1.7770, 1.6318, 2.0714, -2.0929, 1.6110}}, // POINTS_3_BEND
    {{1.5842, 2.7487, 2.9319, -1.4445, 0.2690, 1.3985, -2.1801, 0.0073, -0.9046, -2.4224, -2.8513, 1.2338, -2.7951}}, // SMOOTHED_3_BEND
    {{-0.0433, 1.2976, -1.5367, -2.5967, -0.0885, -1.1342, -0.0089, 3.5052, -0.0562, 2.1833, -1.6087, -1.1589, -1.0023}}, // SMOOTHED_3_MOVES
    {{0.3094, 0.0756, 0.2344, -0.4163, -0.2118, 0.0615, -0.2548, -0.2061, 0.4381, 0.0669, -0.0933, 0.0305, -0.1918}}, // SMOOTHED_3_DRIFT
    {{-0.4643, -0.3119, 0.6780, 0.6834, 1.4038, -0.3760, -1.2955, -0.0709, 2.1523, -1.6776, -2.8563, 0.7052, 0.2680}}, // NOISE
    {{-0.8272, -0.5946, 2.2007, -0.2781, 0.4352, 0.1087, -1.4052, 2.6316, 0.0844, -1.0545, -1.6413, -0.4161, -2.1483}}}}; // IRREGULARITY
// clang-format on

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H
