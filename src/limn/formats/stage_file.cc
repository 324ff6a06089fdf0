#include "limn/formats/stage_file.h"

#include <zlib.h>

#include "limn/formats/atomic_file.h"
#include "limn/formats/whole_file.h"
#include "limn/util/byte_stream.h"

namespace limn {
namespace {

constexpr std::string_view kMagic = "limnfile";
constexpr uint32_t kFormatVersion = 3;
// zlib cannot pack better than this; a header that claims more is wrong.
constexpr uint64_t kMaxRatio = 1100;
constexpr uint64_t kMinUnpacked = 1 << 16;

uint32_t Checksum(std::string_view bytes) {
  uLong sum = crc32_z(0, nullptr, 0);
  sum = crc32_z(sum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return static_cast<uint32_t>(sum);
}

// The doubles of edgels hardly pack, and packing them would take longer than to find them.
int PackingLevel(StageKind kind) {
  return kind == StageKind::kImageCurves ? Z_NO_COMPRESSION : Z_BEST_SPEED;
}

std::string Pack(std::string_view payload, int level) {
  uLongf size = compressBound(payload.size());
  std::string packed(size, '\0');
  const int code = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                             reinterpret_cast<const Bytef*>(payload.data()), payload.size(), level);
  if (code != Z_OK) throw std::bad_alloc();  // the buffer is large enough by construction
  packed.resize(size);
  return packed;
}

std::string Unpack(std::string_view packed, uint64_t size, const ByteReader& reader) {
  reader.Check(size <= kMinUnpacked + kMaxRatio * packed.size(), "impossible payload size");
  std::string payload(size, '\0');
  uLongf unpacked_size = size;
  const int code = uncompress(reinterpret_cast<Bytef*>(payload.data()), &unpacked_size,
                              reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  reader.Check(code == Z_OK && unpacked_size == size, "the payload does not unpack");
  return payload;
}

}  // namespace

void WriteStageFile(const std::string& path, StageKind kind, std::string_view identity,
                    std::string_view payload) {
  ByteWriter writer;
  for (const char c : kMagic) writer.Put(c);
  writer.Put(kFormatVersion);
  writer.Put(static_cast<uint32_t>(kind));
  writer.PutString(identity);
  writer.PutCount(payload.size());
  writer.PutString(Pack(payload, PackingLevel(kind)));
  writer.Put(Checksum(writer.bytes()));
  WriteFileAtomically(path, writer.bytes());
}

std::optional<std::string> ReadStageFile(const std::string& path, StageKind kind,
                                         std::string_view identity) {
  const std::string bytes = ReadWholeFile(path, kMaxMeshBytes);
  ByteReader reader(path, bytes);
  if (!std::string_view(bytes).starts_with(kMagic)) throw IoError(path, "not a stage file of limn");
  reader.Take(kMagic.size());
  if (reader.Get<uint32_t>() != kFormatVersion) return std::nullopt;
  reader.Check(reader.Get<uint32_t>() == static_cast<uint32_t>(kind),
               "the file holds the result of another stage");
  const std::string found_identity = reader.GetString();
  const uint64_t size = reader.Get<uint64_t>();
  const std::string_view packed = reader.Take(reader.GetCount(1));
  const uint32_t checksum = Checksum(std::string_view(bytes).substr(0, reader.at()));
  reader.Check(reader.Get<uint32_t>() == checksum, "damaged: the checksum does not agree");
  reader.ExpectEnd();
  if (!identity.empty() && identity != found_identity) return std::nullopt;
  return Unpack(packed, size, reader);
}

}  // namespace limn
