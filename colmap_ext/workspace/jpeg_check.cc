// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/jpeg_check.h"

#include <csetjmp>
#include <cstdio>
#include <functional>
#include <new>
#include <string_view>
#include <vector>

#include <jpeglib.h>
// After jpeglib.h.
#include <jerror.h>

#include "colmap_ext/workspace/image_header.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// Zero bytes in a row that may be codes: ten blocks of equal frequencies.
constexpr size_t kMaxZeroBytes = 256;

// libjpeg's handlers write here; they are found by the address of `manager`.
struct JpegReport {
  jpeg_error_mgr manager = {};
  std::jmp_buf on_error = {};
  std::string bytes;  // of the file
  std::optional<JpegComplaint> complaint;
  std::string error;
  bool has_memory = true;
  bool has_header = false;
  bool has_end = true;        // its end marker
  bool runs_out = false;      // of codes before the picture is complete
  bool has_all_scans = true;  // meaningful if that is missing
  // The codes of pixels, of a file in which many zero bytes cannot be such codes; else empty.
  std::string_view codes;
};

JpegReport* ReportOf(j_common_ptr decoder) { return reinterpret_cast<JpegReport*>(decoder->err); }

std::string MessageOf(j_common_ptr decoder) {
  char text[JMSG_LENGTH_MAX];
  decoder->err->format_message(decoder, text);
  return text;
}

// Bytes of the file before the next one that the decoder reads. Nothing behind the file's end,
// where libjpeg reads an end marker of its own.
std::optional<size_t> NumBytesRead(j_common_ptr decoder) {
  const std::string_view bytes = ReportOf(decoder)->bytes;
  const auto* next = reinterpret_cast<const char*>(
      reinterpret_cast<j_decompress_ptr>(decoder)->src->next_input_byte);
  const std::less<const char*> is_before;
  if (is_before(next, bytes.data()) || is_before(bytes.data() + bytes.size(), next)) {
    return std::nullopt;
  }
  return static_cast<size_t>(next - bytes.data());
}

// Some cameras fill the end of the picture, or of a file without end marker.
bool IsPadding(j_common_ptr decoder) {
  const std::string_view bytes = ReportOf(decoder)->bytes;
  const size_t end = NumBytesRead(decoder).value_or(bytes.size());
  const auto size = static_cast<size_t>(decoder->err->msg_parm.i[0]);
  if (size > end) return false;
  const std::string_view padding = bytes.substr(end - size, size);
  return padding.find_first_not_of('\0') == std::string_view::npos ||
         padding.find_first_not_of('\xFF') == std::string_view::npos;
}

bool IsDamage(int message) {
  return message == JWRN_EXTRANEOUS_DATA || message == JWRN_HIT_MARKER ||
         message == JWRN_HUFF_BAD_CODE || message == JWRN_ARITH_BAD_CODE ||
         message == JWRN_MUST_RESYNC || message == JWRN_BOGUS_PROGRESSION;
}

// Level -1 is a warning, others are traces.
void TakeMessage(j_common_ptr decoder, int level) {
  if (level >= 0) return;
  const int message = decoder->err->msg_code;
  if (message == JWRN_EXTRANEOUS_DATA && IsPadding(decoder)) return;
  if (message == JWRN_HIT_MARKER || message == JWRN_MUST_RESYNC) {
    ReportOf(decoder)->runs_out = true;
  }
  if (message == JWRN_JPEG_EOF) {
    ReportOf(decoder)->has_end = false;
    return;
  }
  std::optional<JpegComplaint>& complaint = ReportOf(decoder)->complaint;
  if (complaint && (complaint->is_damage || !IsDamage(message))) return;
  complaint = {MessageOf(decoder), IsDamage(message)};
}

[[noreturn]] void TakeError(j_common_ptr decoder) {
  ReportOf(decoder)->error = MessageOf(decoder);
  ReportOf(decoder)->has_memory = decoder->err->msg_code != JERR_OUT_OF_MEMORY;
  std::longjmp(ReportOf(decoder)->on_error, 1);
}

// At an eighth of the size only the means of blocks are computed.
void ReadCodesOnly(jpeg_decompress_struct* decoder) {
  decoder->scale_num = 1;
  decoder->scale_denom = 8;
  decoder->dct_method = JDCT_IFAST;
  decoder->do_fancy_upsampling = FALSE;
  decoder->out_color_space = decoder->jpeg_color_space;
}

// As OpenCV does.
void MakePixels(int reduction, jpeg_decompress_struct* decoder) {
  decoder->scale_num = 1;
  decoder->scale_denom = static_cast<unsigned>(reduction);
  decoder->out_color_space = decoder->num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
}

// Zero bits are the first code of each table. If that of brightness does not end a block, they are
// blocks of 63 equal frequencies, which no picture has many of. Files of one scan only, since in
// the others brightness and color are apart.
bool MayHoldManyZeros(jpeg_decompress_struct* decoder) {
  if (jpeg_has_multiple_scans(decoder) || decoder->arith_code) return true;
  const int number = decoder->comp_info[0].ac_tbl_no;
  if (number < 0 || number >= NUM_HUFF_TBLS) return true;
  const JHUFF_TBL* table = decoder->ac_huff_tbl_ptrs[number];
  constexpr UINT8 kEndOfBlock = 0;
  return !table || table->huffval[0] == kEndOfBlock;
}

// Whether the scans that were read give all bits of all frequencies. Of files of several scans only
// progressive ones tell.
bool HasAllScans(jpeg_decompress_struct* decoder) {
  if (!jpeg_has_multiple_scans(decoder)) return true;
  if (!decoder->progressive_mode || !decoder->coef_bits) return false;
  for (int component = 0; component < decoder->num_components; ++component) {
    for (int frequency = 0; frequency < DCTSIZE2; ++frequency) {
      if (decoder->coef_bits[component][frequency] != 0) return false;
    }
  }
  return true;
}

// `reduction` 0: only the codes, and `rows` is one row. A jump out of here passes no destructors:
// all objects belong to the caller.
void ReadRows(int reduction, jpeg_decompress_struct* decoder, std::vector<JSAMPLE>* rows,
              JpegReport* report) {
  if (setjmp(report->on_error) != 0) return;
  jpeg_create_decompress(decoder);
  jpeg_mem_src(decoder, reinterpret_cast<const unsigned char*>(report->bytes.data()),
               report->bytes.size());
  jpeg_read_header(decoder, TRUE);
  report->has_header = true;
  if (reduction > 0) {
    if (decoder->num_components != 1 && decoder->num_components != 3) return;
    MakePixels(reduction, decoder);
  } else {
    ReadCodesOnly(decoder);
  }
  const bool may_hold_zeros = MayHoldManyZeros(decoder);
  const auto common = reinterpret_cast<j_common_ptr>(decoder);
  const auto begin = NumBytesRead(common);
  jpeg_start_decompress(decoder);
  const size_t row_size = static_cast<size_t>(decoder->output_width) * decoder->output_components;
  rows->resize(reduction > 0 ? row_size * decoder->output_height : row_size);
  while (decoder->output_scanline < decoder->output_height) {
    JSAMPROW row = rows->data() + (reduction > 0 ? row_size * decoder->output_scanline : 0);
    jpeg_read_scanlines(decoder, &row, 1);
  }
  report->has_all_scans = HasAllScans(decoder);
  // Without what fills the end of the file.
  const auto end = NumBytesRead(common);
  if (!may_hold_zeros && begin && end) {
    report->codes = std::string_view(report->bytes).substr(*begin, *end - *begin);
  }
  jpeg_finish_decompress(decoder);
}

// Without its end marker.
void ComplainOfEnd(JpegReport* report) {
  if (report->runs_out || !report->has_all_scans || !report->error.empty()) {
    report->complaint = {"the file ends before the picture does", true, true};
  } else if (!report->complaint || !report->complaint->is_damage) {
    report->complaint = {"lacks the end marker of a JPEG file, but nothing of its picture"};
  }
}

struct JpegDecoder {
  JpegDecoder() = default;
  ~JpegDecoder() { jpeg_destroy_decompress(&state); }
  JpegDecoder(const JpegDecoder&) = delete;
  JpegDecoder& operator=(const JpegDecoder&) = delete;

  jpeg_decompress_struct state = {};
};

// The same; width, height and channels of the rows. Throws std::bad_alloc.
JpegPixels ReadFile(const std::filesystem::path& path, int reduction, JpegReport* report) {
  report->bytes = ReadWholeFile(path.string());
  JpegDecoder decoder;
  decoder.state.err = jpeg_std_error(&report->manager);
  report->manager.emit_message = TakeMessage;
  report->manager.error_exit = TakeError;
  JpegPixels pixels;
  ReadRows(reduction, &decoder.state, &pixels.data, report);
  if (!report->has_memory) throw std::bad_alloc();
  pixels.width = static_cast<int>(decoder.state.output_width);
  pixels.height = static_cast<int>(decoder.state.output_height);
  pixels.channels = decoder.state.output_components;
  if (report->codes.find(std::string(kMaxZeroBytes, '\0')) != std::string_view::npos) {
    report->complaint = {"Corrupt JPEG data: zero bytes in place of codes", true};
  }
  if (!report->has_end) ComplainOfEnd(report);
  return pixels;
}

}  // namespace

std::optional<JpegComplaint> CheckJpeg(const std::filesystem::path& path) {
  if (FormatOf(path) != ImageFormat::kJpeg) return std::nullopt;
  JpegReport report;
  ReadFile(path, 0, &report);
  if (report.error.empty()) return report.complaint;
  if (!report.has_header) throw IoError(path.string(), "cannot be decoded: " + report.error);
  return JpegComplaint{report.error, true, !report.has_end};
}

std::optional<JpegPixels> DecodeJpeg(const std::filesystem::path& path, int reduction) {
  if (FormatOf(path) != ImageFormat::kJpeg) return std::nullopt;
  JpegReport report;
  JpegPixels pixels = ReadFile(path, reduction, &report);
  if (!report.error.empty()) throw IoError(path.string(), "cannot be decoded: " + report.error);
  if (pixels.data.empty()) return std::nullopt;
  return pixels;
}

}  // namespace limn::colmap_ext
