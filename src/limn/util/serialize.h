// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include "limn/util/byte_stream.h"
#include "limn/util/fields.h"

namespace limn {

// Converts plain values to bytes, for other processes of the same program: numbers, enums, strings,
// fixed-size Eigen matrices, vectors and optionals of plain values, and structs of up to eight
// public fields of plain values, without declarations.
template <class T>
void Serialize(const T& value, ByteWriter* out);
template <class T>
void Deserialize(ByteReader* in, T* value);

namespace internal {

template <class T>
constexpr bool kIsVector = false;
template <class T>
constexpr bool kIsVector<std::vector<T>> = true;
template <class T>
constexpr bool kIsOptional = false;
template <class T>
constexpr bool kIsOptional<std::optional<T>> = true;

template <class T>
constexpr bool IsFixedMatrix() {
  if constexpr (std::is_base_of_v<Eigen::PlainObjectBase<T>, T>) {
    return T::SizeAtCompileTime != Eigen::Dynamic;
  }
  return false;
}

}  // namespace internal

template <class T>
void Serialize(const T& value, ByteWriter* out) {
  if constexpr (std::is_arithmetic_v<T>) {
    out->Put(value);
  } else if constexpr (std::is_enum_v<T>) {
    out->Put(static_cast<std::underlying_type_t<T>>(value));
  } else if constexpr (std::is_same_v<T, std::string>) {
    out->PutString(value);
  } else if constexpr (internal::IsFixedMatrix<T>()) {
    out->PutArray(value.data(), value.size());
  } else if constexpr (internal::kIsOptional<T>) {
    out->Put(value.has_value());
    if (value) Serialize(*value, out);
  } else if constexpr (internal::kIsVector<T>) {
    out->PutCount(value.size());
    if constexpr (std::is_arithmetic_v<typename T::value_type>) {
      out->PutArray(value.data(), value.size());
    } else {
      for (const auto& item : value) Serialize(item, out);
    }
  } else {
    static_assert(std::is_aggregate_v<T>, "only plain values can be serialized");
    ForEachField(value, [&](const auto& field) { Serialize(field, out); });
  }
}

template <class T>
void Deserialize(ByteReader* in, T* value) {
  if constexpr (std::is_arithmetic_v<T>) {
    *value = in->Get<T>();
  } else if constexpr (std::is_enum_v<T>) {
    *value = static_cast<T>(in->Get<std::underlying_type_t<T>>());
  } else if constexpr (std::is_same_v<T, std::string>) {
    *value = in->GetString();
  } else if constexpr (internal::IsFixedMatrix<T>()) {
    in->GetArray(value->data(), value->size());
  } else if constexpr (internal::kIsOptional<T>) {
    value->reset();
    if (in->Get<bool>()) Deserialize(in, &value->emplace());
  } else if constexpr (internal::kIsVector<T>) {
    if constexpr (std::is_arithmetic_v<typename T::value_type>) {
      value->resize(in->GetCount(sizeof(typename T::value_type)));
      in->GetArray(value->data(), value->size());
    } else {
      value->resize(in->GetCount(1));
      for (auto& item : *value) Deserialize(in, &item);
    }
  } else {
    static_assert(std::is_aggregate_v<T>, "only plain values can be serialized");
    ForEachField(*value, [&](auto& field) { Deserialize(in, &field); });
  }
}

}  // namespace limn
