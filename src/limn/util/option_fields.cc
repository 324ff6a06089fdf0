// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/option_fields.h"

#include <sstream>

#include "limn/util/errors.h"

namespace limn {
namespace {

std::string Describe(const OptionValues& values) {
  std::ostringstream text;
  text.precision(10);
  if (values.or_zero) text << "0 or ";
  text << (values.above_low ? "> " : ">= ") << values.low << " and <= " << values.high;
  return text.str();
}

}  // namespace

OptionValues Between(double low, double high) { return {.low = low, .high = high}; }

OptionValues Above(double low, double high) {
  return {.low = low, .high = high, .above_low = true};
}

OptionValues ZeroOr(OptionValues values) {
  values.or_zero = true;
  return values;
}

OptionValues OneOf(std::initializer_list<const char*> words) {
  return {.low = 0, .high = static_cast<double>(words.size()) - 1, .words = words};
}

OptionValues OnOrOff() { return Between(0, 1); }

void CheckOptionValue(const char* name, double value, const OptionValues& values) {
  const bool is_high_enough = values.above_low ? value > values.low : value >= values.low;
  const bool ok = (is_high_enough && value <= values.high) || (values.or_zero && value == 0);
  if (!ok) CheckOption(false, name, value, Describe(values).c_str());
}

}  // namespace limn
