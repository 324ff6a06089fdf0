// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/byte_stream.h"

#include <array>
#include <functional>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn {
namespace {

using ::testing::HasSubstr;

// More than a reader of a stream takes at a time, and no multiple of it.
constexpr size_t kManyValues = 50001;

std::vector<int32_t> ManyValues() {
  std::vector<int32_t> values(kManyValues);
  std::iota(values.begin(), values.end(), -7);
  return values;
}

std::string WriteAll() {
  ByteWriter out;
  out.Put<uint8_t>(200);
  out.Put(-1.5);
  out.PutString("a name");
  out.PutCount(kManyValues);
  out.PutArray(ManyValues().data(), kManyValues);
  out.PutString(std::string(100000, 'x'));
  for (const int32_t value : ManyValues()) out.Put(value);
  out.PutArray(std::array<double, 3>{1, 2, 3}.data(), 3);
  return out.bytes();
}

void ExpectAll(ByteReader* in) {
  EXPECT_EQ(in->Get<uint8_t>(), 200);
  EXPECT_EQ(in->Get<double>(), -1.5);
  EXPECT_EQ(in->at(), 9u);
  EXPECT_EQ(in->GetString(), "a name");
  std::vector<int32_t> values(in->GetCount(sizeof(int32_t)));
  in->GetArray(values.data(), values.size());
  EXPECT_EQ(values, ManyValues());
  EXPECT_EQ(in->Take(in->GetCount(1)), std::string(100000, 'x'));
  for (const int32_t value : ManyValues()) ASSERT_EQ(in->Get<int32_t>(), value);
  EXPECT_EQ((in->Get<std::array<double, 3>>()), (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(in->Remaining(), 0u);
  in->ExpectEnd();
}

std::string ErrorText(const std::function<void()>& body) {
  try {
    body();
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(ByteReader, ReadsFromMemoryWhatWasWritten) {
  const std::string bytes = WriteAll();
  ByteReader in("file", bytes);
  ExpectAll(&in);
}

TEST(ByteReader, ReadsFromTheMiddleOfAStreamWhatWasWritten) {
  std::istringstream stream("before" + WriteAll());
  stream.seekg(6);
  ByteReader in("file", stream);
  ExpectAll(&in);
}

TEST(ByteReader, NeverReadsBeyondTheEnd) {
  ByteWriter out;
  out.Put<uint32_t>(1);
  out.PutString("name");
  for (size_t size = 0; size < out.bytes().size(); ++size) {
    const std::string cut = out.bytes().substr(0, size);
    std::istringstream stream(cut);
    ByteReader from_memory("file", cut);
    ByteReader from_stream("file", stream);
    for (ByteReader* in : {&from_memory, &from_stream}) {
      EXPECT_THAT(ErrorText([&] {
                    in->Get<uint32_t>("a number");
                    in->GetString();
                  }),
                  HasSubstr("file: byte "))
          << size;
    }
  }
}

TEST(ByteReader, SaysWhatIsMissingWhereAndWhatIsLeftOver) {
  const std::string bytes(6, '\1');
  ByteReader in("file", bytes);
  in.Get<uint32_t>();
  EXPECT_EQ(ErrorText([&] { in.Get<double>("width"); }),
            "file: byte 4: truncated: 8 bytes expected for width, 2 left");
  EXPECT_THAT(ErrorText([&] { in.ExpectEnd(); }), HasSubstr("byte 4: 2 bytes after"));
  EXPECT_EQ(ErrorText([&] { in.At(1).Fail("odd"); }), "file: byte 1: odd");
}

TEST(ByteReader, RejectsCountsThatTheFileCannotHold) {
  ByteWriter out;
  out.PutCount(3);
  out.Put<uint64_t>(0);
  out.Put<uint32_t>(0);
  ByteReader fitting("file", out.bytes());
  EXPECT_EQ(fitting.GetCount(4), 3u);
  ByteReader too_many("file", out.bytes());
  EXPECT_THAT(ErrorText([&] { too_many.GetCount(5); }), HasSubstr("exceeds the file"));
}

}  // namespace
}  // namespace limn
