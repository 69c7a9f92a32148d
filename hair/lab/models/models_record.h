// models.json: a comparison of strand models for programs to read.
#pragma once

#include <string>
#include <string_view>

#include "hair/lab/models/comparison.h"

namespace hair::model_study {

inline constexpr std::string_view kModelsRecordBegin = "{\n  \"program\": \"hairlab models\"";

std::string models_json(const Comparison& comparison, const std::string& machine);

}  // namespace hair::model_study
