#include "limn/drawing/working_curve.h"

namespace limn {
namespace {

template <typename Matrix>
void PutAll(const std::vector<Matrix>& matrices, ByteWriter* out) {
  for (const Matrix& matrix : matrices) out->PutArray(matrix.data(), matrix.size());
}

template <typename Matrix>
void GetAll(size_t count, ByteReader* in, std::vector<Matrix>* matrices) {
  matrices->resize(count);
  for (Matrix& matrix : *matrices) in->GetArray(matrix.data(), matrix.size());
}

}  // namespace

void Put(const WorkingCurve& curve, ByteWriter* out) {
  const size_t count = curve.position.size();
  out->PutCount(count);
  PutAll(curve.position, out);
  PutAll(curve.tangent, out);
  PutAll(curve.information, out);
  out->PutArray(curve.footprint.data(), count);
  for (const std::vector<EdgelRef>& support : curve.support) {
    out->PutCount(support.size());
    for (const EdgelRef& ref : support) {
      out->Put<int32_t>(ref.view);
      out->Put<int32_t>(ref.edgel);
    }
  }
  out->PutArray(curve.supported.data(), count);
  out->Put<uint8_t>(curve.closed);
}

void Get(ByteReader* in, WorkingCurve* curve) {
  const size_t count = in->GetCount(sizeof(double));
  GetAll(count, in, &curve->position);
  GetAll(count, in, &curve->tangent);
  GetAll(count, in, &curve->information);
  curve->footprint.resize(count);
  in->GetArray(curve->footprint.data(), count);
  curve->support.resize(count);
  for (std::vector<EdgelRef>& support : curve->support) {
    support.resize(in->GetCount(2 * sizeof(int32_t)));
    for (EdgelRef& ref : support) {
      ref.view = in->Get<int32_t>();
      ref.edgel = in->Get<int32_t>();
    }
  }
  curve->supported.resize(count);
  in->GetArray(curve->supported.data(), count);
  curve->closed = in->Get<uint8_t>() != 0;
}

}  // namespace limn
