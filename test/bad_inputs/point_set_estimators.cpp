#include "estimator_list.h"

template std::vector<bad_inputs::Estimator<bad_inputs::Point_set>> bad_inputs::estimators();
