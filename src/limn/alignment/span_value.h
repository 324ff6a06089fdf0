// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "limn/alignment/drawing_span.h"

namespace limn {

// What options say of a span.
struct SpanValue {
  DrawingSpan span;
  std::string value;  // what is behind the last "="
};

// From "<span> = <value>" (ParseSpan). Nothing for other texts, and for longer ones.
constexpr size_t kMaxSpanValueBytes = 700;
std::optional<SpanValue> ParseSpanValue(const std::string& text);

}  // namespace limn
