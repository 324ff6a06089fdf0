// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/name_encoding.h"

#include <algorithm>
#include <map>
#include <memory>

#include <unicode/ucnv.h>
#include <unicode/unorm2.h>
#include <unicode/ustring.h>

namespace limn::colmap_ext {
namespace {

using Utf16 = std::basic_string<UChar>;

constexpr const char* kUtf8 = "UTF-8";

// Those of Windows, DOS and Unix: Chinese, Japanese and Korean first, since most bytes are no text
// in them, then those in which nearly all bytes are.
constexpr const char* kCodePages[] = {
    "gb18030",      "windows-950",  "windows-932",  "euc-jp",       "windows-949",  "windows-1252",
    "windows-1250", "windows-1251", "koi8-r",       "windows-1253", "windows-1254", "windows-1255",
    "windows-1256", "windows-1257", "windows-1258", "windows-874",  "ibm-437",      "ibm-850",
    "ibm-852",      "ibm-866",      "macintosh"};
// What programs that unpack archives take bytes for.
constexpr const char* kMistakes[] = {"ibm-437", "ibm-850", "windows-1252", "iso-8859-1"};

using Converter = std::unique_ptr<UConverter, void (*)(UConverter*)>;

// Null if ICU does not have it. Converters are slow to open; each thread keeps its own.
UConverter* ConverterOf(const std::string& code_page) {
  thread_local std::map<std::string, Converter> opened;
  const auto found = opened.find(code_page);
  if (found != opened.end()) return found->second.get();
  UErrorCode error = U_ZERO_ERROR;
  Converter converter(ucnv_open(code_page.c_str(), &error), &ucnv_close);
  if (converter) {
    ucnv_setToUCallBack(converter.get(), UCNV_TO_U_CALLBACK_STOP, nullptr, nullptr, nullptr,
                        &error);
    ucnv_setFromUCallBack(converter.get(), UCNV_FROM_U_CALLBACK_STOP, nullptr, nullptr, nullptr,
                          &error);
  }
  return opened.emplace(code_page, std::move(converter)).first->second.get();
}

std::optional<Utf16> ToUtf16(std::string_view bytes, const std::string& code_page) {
  UConverter* converter = ConverterOf(code_page);
  if (!converter) return std::nullopt;
  Utf16 text(2 * bytes.size() + 1, 0);
  UErrorCode error = U_ZERO_ERROR;
  const int32_t size = ucnv_toUChars(converter, text.data(), static_cast<int32_t>(text.size()),
                                     bytes.data(), static_cast<int32_t>(bytes.size()), &error);
  if (U_FAILURE(error)) return std::nullopt;
  text.resize(static_cast<size_t>(size));
  return text;
}

std::optional<std::string> FromUtf16(const Utf16& text, const std::string& code_page) {
  UConverter* converter = ConverterOf(code_page);
  if (!converter) return std::nullopt;
  std::string bytes(4 * text.size() + 16, '\0');
  UErrorCode error = U_ZERO_ERROR;
  const int32_t size = ucnv_fromUChars(converter, bytes.data(), static_cast<int32_t>(bytes.size()),
                                       text.data(), static_cast<int32_t>(text.size()), &error);
  if (U_FAILURE(error)) return std::nullopt;
  bytes.resize(static_cast<size_t>(size));
  return bytes;
}

// What a program took for text of a code page, as it was before. Code pages have one micro sign,
// Unicode has two.
std::optional<std::string> Unconverted(Utf16 text, const std::string& code_page) {
  if (auto bytes = FromUtf16(text, code_page)) return bytes;
  constexpr UChar kMicro = 0x00B5, kGreekMu = 0x03BC;
  std::ranges::replace(text, kMicro, kGreekMu);
  return FromUtf16(text, code_page);
}

std::optional<Utf16> Composed(const Utf16& text) {
  UErrorCode error = U_ZERO_ERROR;
  const UNormalizer2* normalizer = unorm2_getNFCInstance(&error);
  if (U_FAILURE(error)) return std::nullopt;
  Utf16 composed(3 * text.size() + 1, 0);  // no character grows more
  const int32_t size =
      unorm2_normalize(normalizer, text.data(), static_cast<int32_t>(text.size()), composed.data(),
                       static_cast<int32_t>(composed.size()), &error);
  if (U_FAILURE(error)) return std::nullopt;
  composed.resize(static_cast<size_t>(size));
  return composed;
}

std::vector<NameEncoding> AllEncodings() {
  std::vector<NameEncoding> all = {{kUtf8, "", ""}};
  for (const char* page : kCodePages) all.push_back({page, page, ""});
  for (const char* mistake : kMistakes) {
    all.push_back({std::string("UTF-8 read as ") + mistake, "", mistake});
    for (const char* page : kCodePages) {
      if (page == std::string_view(mistake)) continue;
      all.push_back({std::string(page) + " read as " + mistake, page, mistake});
    }
  }
  return all;
}

}  // namespace

const std::vector<NameEncoding>& NameEncodings() {
  static const std::vector<NameEncoding> all = AllEncodings();
  return all;
}

std::optional<std::string> TextOfName(std::string_view bytes, const NameEncoding& encoding) {
  std::string original(bytes);
  if (!encoding.mistaken_for.empty()) {
    const auto mistaken = ToUtf16(bytes, kUtf8);
    auto before = mistaken ? Unconverted(*mistaken, encoding.mistaken_for) : std::nullopt;
    if (!before) return std::nullopt;
    original = std::move(*before);
  }
  const auto text = ToUtf16(original, encoding.code_page.empty() ? kUtf8 : encoding.code_page);
  const auto composed = text ? Composed(*text) : std::nullopt;
  auto name = composed ? FromUtf16(*composed, kUtf8) : std::nullopt;
  if (name) std::ranges::replace(*name, '\\', '/');
  return name;
}

}  // namespace limn::colmap_ext
