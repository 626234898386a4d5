// SPDX-License-Identifier: Apache-2.0
// This header writes metrics of result.json into a page, with their labels and units of the table
// of metrics.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "output/result_metrics.hpp"
#include "report/html.hpp"

namespace kerf {

// Returns the value at the path `name` of result.json, null where there is none.
const nlohmann::ordered_json* find_value(const nlohmann::ordered_json& result,
                                         const std::string& name);
// Returns the label as HTML: "c_R" has its index set low.
std::string label_html(const std::string& label);
// Returns the value of a metric as HTML, with a suitable prefix of its unit: angles in degrees,
// shares in per cent, volumes in mm³ (2D: mm²); "—" where there is none.
std::string value_html(const nlohmann::ordered_json& result, const ResultMetric& metric,
                       int digits = 4);
// Returns by how much a metric of the second result differs from that of the first, with its sign
// and in per cent of the first; empty where one of them has no number. The difference of shares is
// in per cent of the whole.
std::string difference_html(const nlohmann::ordered_json& first,
                            const nlohmann::ordered_json& second, const ResultMetric& metric,
                            int digits = 3);
// Returns a row of a table: label, value, remark and the metric's name as key. `name` is in the
// table of metrics.
html::Row metric_row(const nlohmann::ordered_json& result, const std::string& name,
                     std::string remark = {});

}  // namespace kerf
