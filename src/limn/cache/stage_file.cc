// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/stage_file.h"

#include <fstream>
#include <ostream>

#include <zlib.h>

#include "limn/files/atomic_file.h"
#include "limn/files/whole_file.h"
#include "limn/util/byte_stream.h"

namespace limn {
namespace {

constexpr std::string_view kMagic = "limnfile";
constexpr uint32_t kFormatVersion = 7;

// Of bytes that follow others with this checksum.
uint32_t Checksum(std::string_view bytes, uint32_t of_others = 0) {
  return static_cast<uint32_t>(
      crc32_z(of_others, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// The identity; nothing if the file is of another version.
std::optional<std::string> ReadHead(const std::string& path, StageKind kind, ByteReader* reader) {
  if (reader->Remaining() < kMagic.size() || reader->Take(kMagic.size()) != kMagic) {
    throw IoError(path, "not a stage file of limn");
  }
  if (reader->Get<uint32_t>() != kFormatVersion) return std::nullopt;
  reader->Check(reader->Get<uint32_t>() == static_cast<uint32_t>(kind),
                "the file holds the result of another stage");
  return reader->GetString();
}

}  // namespace

void WriteStageFile(const OutputPath& path, StageKind kind, std::string_view identity,
                    std::string_view payload) {
  ByteWriter head;
  for (const char c : kMagic) head.Put(c);
  head.Put(kFormatVersion);
  head.Put(static_cast<uint32_t>(kind));
  head.PutString(identity);
  head.PutCount(payload.size());
  ByteWriter tail;
  tail.Put(Checksum(payload, Checksum(head.bytes())));
  WriteFileAtomically(path,
                      [&](std::ostream& out) { out << head.bytes() << payload << tail.bytes(); });
}

std::optional<std::string> ReadStageFile(const std::string& path, StageKind kind,
                                         std::string_view identity) {
  std::string bytes = ReadWholeFile(path, kMaxMeshBytes);
  ByteReader reader(path, bytes);
  const std::optional<std::string> found_identity = ReadHead(path, kind, &reader);
  if (!found_identity) return std::nullopt;
  const size_t size = reader.GetCount(1);
  const auto begin = static_cast<size_t>(reader.at());
  reader.Take(size);
  const uint32_t checksum = Checksum(std::string_view(bytes).substr(0, begin + size));
  reader.Check(reader.Get<uint32_t>() == checksum, "damaged: the checksum does not agree");
  reader.ExpectEnd();
  if (!identity.empty() && identity != *found_identity) return std::nullopt;
  // In place: payloads are large.
  bytes.resize(begin + size);
  bytes.erase(0, begin);
  return bytes;
}

std::string FirstTextOfStageFile(const std::string& path, StageKind kind) {
  try {
    std::ifstream in = OpenFile(path);
    ByteReader reader(path, in);
    if (!ReadHead(path, kind, &reader)) return "";
    reader.GetCount(1);
    return reader.GetString();
  } catch (const IoError&) {
    return "";
  }
}

}  // namespace limn
