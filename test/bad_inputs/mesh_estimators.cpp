#include "estimator_list.h"

template std::vector<bad_inputs::Estimator<bad_inputs::Mesh>> bad_inputs::estimators();
