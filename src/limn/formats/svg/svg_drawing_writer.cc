// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/svg/svg_drawing_writer.h"

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "limn/formats/colors.h"
#include "limn/formats/svg/dimensions.h"
#include "limn/formats/svg/legend.h"
#include "limn/formats/svg/link.h"
#include "limn/model/drawing_paths.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"

namespace limn {
namespace {

// Positions are rounded by at most this many pixels.
constexpr double kRoundingPx = 0.005;

// Lines of a section, in widths of other lines.
constexpr double kSectionWidths = 3;
// Radius of its marks, the same.
constexpr double kSectionMarkWidths = 2;

std::string HexColor(const Color& color) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text = "#";
  for (const uint8_t channel : {color.red, color.green, color.blue}) {
    text += kDigits[channel >> 4];
    text += kDigits[channel & 15];
  }
  return text;
}

// Percent-encodes what may not stand in the path of a URL reference; UTF-8 passes.
std::string UrlPath(const std::string& path) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string url;
  for (const char c : path) {
    if (c == ' ' || c == '%' || c == '#' || c == '?' || c == '"' || c == '\\') {
      url += '%';
      url += kDigits[static_cast<unsigned char>(c) >> 4];
      url += kDigits[c & 15];
    } else {
      url += c;
    }
  }
  return url;
}

// What differs between a view and a sheet.
struct Picture {
  // Attributes width, height and viewBox.
  std::string size;
  std::string description;
  // Units of the picture in a pixel, and decimals of its numbers.
  double px = 1;
  int decimals = 2;
  std::function<LinkPath(const DrawingLink&)> draw_link;
  // Nothing where a node is not in the picture.
  std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector3d&)> place_of;
  std::function<void(std::ostream&)> background = [](std::ostream&) {};
  std::function<void(std::ostream&)> legend = [](std::ostream&) {};
};

class SvgWriter {
 public:
  SvgWriter(const DrawingGraph& graph, const Picture& picture, const SvgOptions& options,
            std::ostream& out)
      : graph_(graph), curves_(CurvesOf(graph)), picture_(picture), options_(options), out_(out) {}

  SvgSummary Write() {
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
         << picture_.size << ">\n<title>" << XmlEscaped(options_.title) << "</title>\n<desc>"
         << XmlEscaped(picture_.description) << "</desc>\n";
    PutStyle();
    picture_.background(out_);
    const SvgSummary summary = PutLinks();
    if (options_.junctions) PutJunctions();
    if (options_.section) PutSection(*options_.section);
    if (!graph_.dimensions.empty()) {
      WriteDimensions(graph_.dimensions,
                      {picture_.place_of, picture_.px, picture_.decimals, options_.dimension_text},
                      out_);
    }
    picture_.legend(out_);
    out_ << "</svg>\n";
    return summary;
  }

 private:
  std::string Pixels(double px) const { return SvgNumber(px * picture_.px, picture_.decimals); }

  void PutRule(const char* what, const char* color) {
    out_ << what << "{stroke:" << color << "}\n";
  }

  void PutStyle() {
    out_ << "<style>\n#links{fill:none;stroke:#000;stroke-width:" << Pixels(options_.line_width_px)
         << ";stroke-linecap:round;stroke-linejoin:round}\n"
         << ".hidden{stroke-opacity:.6;stroke-linecap:butt;stroke-dasharray:" << Pixels(3) << ' '
         << Pixels(2) << "}\n"
         << "#junctions{fill:#fff;stroke:#000;stroke-width:" << Pixels(0.75) << "}\n"
         << "#legend{fill:none;stroke:#000;stroke-width:.75}\n"
            "#legend circle,#legend text{fill:#000;stroke:none}\n"
         << "#legend text{font:" << SvgNumber(kLegendTextPx, 2) << "px sans-serif}\n";
    if (options_.section) {
      out_ << "#section{fill:none;stroke:#000;stroke-width:"
           << Pixels(kSectionWidths * options_.line_width_px)
           << ";stroke-linejoin:miter}\n#section circle{fill:#000;stroke:none}\n";
    }
    if (!graph_.dimensions.empty()) {
      out_ << "#dimensions{fill:none;stroke:#000;stroke-width:" << Pixels(0.75)
           << "}\n#dimensions text{fill:#000;stroke:none;text-anchor:middle;font:"
           << SvgNumber(kLegendTextPx, 2) << "px sans-serif}\n";
    }
    if (options_.colors == SvgColors::kPrimitive) {
      PutRule(".line", "#0072b2");
      PutRule(".arc", "#d55e00");
      PutRule(".circle", "#cc79a7");
      PutRule(".spline", "#009e73");
      PutRule(".polyline", "#777");
    }
    if (options_.colors == SvgColors::kClass) {
      PutRule(".surface", "#0072b2");
      PutRule(".boundary", "#d55e00");
      PutRule(".free", "#009e73");
      PutRule(".unknown", "#777");
    }
    if (options_.colors == SvgColors::kKind) {
      PutRule(".kind-paint", "#d55e00");
      PutRule(".kind-shadow", "#56b4e9");
      PutRule(".kind-contour", "#cc79a7");
      PutRule(".kind-rod", "#009e73");
      PutRule(".kind-texture", "#bbb");
    }
    out_ << "</style>\n";
  }

  SvgSummary PutLinks() {
    end_is_open_.resize(graph_.links.size());
    SvgSummary summary;
    out_ << "<g id=\"links\">\n";
    for (size_t id = 0; id < graph_.links.size(); ++id) {
      const LinkPath path = picture_.draw_link(graph_.links[id]);
      end_is_open_[id] = {path.end_is_open[0], path.end_is_open[1]};
      const bool shows_hidden =
          options_.hidden_parts == SvgHiddenParts::kDashed && !path.hidden.empty();
      if (!path.visible.empty() || shows_hidden) {
        ++summary.num_drawn;
        PutLink(id, path, shows_hidden);
      } else {
        ++(path.hidden.empty() ? summary.num_outside : summary.num_hidden);
      }
    }
    out_ << "</g>\n";
    return summary;
  }

  // "link_7"; of further parts of a link that a plan cuts "link_7_1" and so on.
  std::string IdOf(size_t id) {
    const LinkId number = NumberOfLink(graph_, id);
    const int part = num_parts_[number]++;
    const std::string name = "link_" + std::to_string(number);
    return part == 0 ? name : name + "_" + std::to_string(part);
  }

  void PutLink(size_t id, const LinkPath& path, bool shows_hidden) {
    const DrawingLink& link = graph_.links[id];
    out_ << (shows_hidden ? "<g" : "<path") << " id=\"" << IdOf(id) << "\" class=\""
         << (link.primitive ? ShapeName(link.primitive->shape) : "polyline");
    if (link.dense) out_ << ' ' << DenseClassName(link.dense->dense_class);
    if (link.kind != LinkKind::kUnknown) out_ << " kind-" << LinkKindName(link.kind);
    if (link.tentative) out_ << " tentative";
    out_ << '"';
    if (link.kind == LinkKind::kRod) {
      out_ << " data-radius=\"" << NumberText(link.rod_radius) << '"';
    }
    if (options_.colors == SvgColors::kLink) {
      out_ << " stroke=\"" << HexColor(ColorOfCurve(curves_[id])) << '"';
    }
    if (!shows_hidden) {
      out_ << " d=\"" << path.visible.text() << "\"/>\n";
      return;
    }
    out_ << '>';
    if (!path.visible.empty()) out_ << "<path d=\"" << path.visible.text() << "\"/>";
    out_ << "<path class=\"hidden\" d=\"" << path.hidden.text() << "\"/></g>\n";
  }

  bool IsSeen(const DrawingNode& node) const {
    for (const LinkEnd& end : node.incident) {
      if (end_is_open_[end.link][end.end]) return true;
    }
    return false;
  }

  void PutJunctions() {
    out_ << "<g id=\"junctions\">\n";
    for (size_t id = 0; id < graph_.nodes.size(); ++id) {
      const DrawingNode& node = graph_.nodes[id];
      if (node.kind != NodeKind::kJunction || !IsSeen(node)) continue;
      const auto place = picture_.place_of(node.position_in_world);
      if (!place) continue;
      out_ << "<circle id=\"node_" << NumberOfNode(graph_, id) << "\" cx=\""
           << SvgNumber(place->x(), picture_.decimals) << "\" cy=\""
           << SvgNumber(place->y(), picture_.decimals) << "\" r=\""
           << Pixels(options_.junction_radius_px) << "\"/>\n";
    }
    out_ << "</g>\n";
  }

  void PutSection(const Section& section) {
    out_ << "<g id=\"section\">\n";
    for (const SectionLine& line : section.lines) {
      SvgPath path(picture_.decimals);
      for (const Eigen::Vector3d& point : line.points) {
        const auto place = picture_.place_of(point);
        if (place) path.empty() ? path.MoveTo(*place) : path.LineTo(*place);
      }
      out_ << "<path class=\"" << (line.closed ? "closed" : "open") << "\" d=\"" << path.text()
           << (line.closed ? "z" : "") << "\"/>\n";
    }
    for (const Eigen::Vector3d& point : section.points) {
      const auto place = picture_.place_of(point);
      if (!place) continue;
      out_ << "<circle cx=\"" << SvgNumber(place->x(), picture_.decimals) << "\" cy=\""
           << SvgNumber(place->y(), picture_.decimals) << "\" r=\""
           << Pixels(kSectionMarkWidths * options_.line_width_px) << "\"/>\n";
    }
    out_ << "</g>\n";
  }

  const DrawingGraph& graph_;
  const std::vector<LinkId> curves_;
  std::map<LinkId, int> num_parts_;  // written
  const Picture& picture_;
  const SvgOptions& options_;
  std::ostream& out_;
  std::vector<std::array<bool, 2>> end_is_open_;
};

LinkPathOptions PathOptions(const SvgOptions& options, int decimals) {
  return {options.use_primitives, options.tolerance_px, options.min_run_px, decimals};
}

std::string SheetDescription(const SvgSheet& sheet) {
  std::string text = sheet.unit == LengthUnit::kNone
                         ? "Without a scale: the unit is that of the model"
                         : "Scale " + ScaleText(sheet) + "; unit " + UnitName(sheet.unit);
  text += "; right and down from ";
  constexpr int kDecimals = 3;
  return text + SvgNumber(sheet.origin.x(), kDecimals) + ", " +
         SvgNumber(sheet.origin.y(), kDecimals) + ".";
}

}  // namespace

void SvgOptions::Check() const {
  LIMN_CHECK_RANGE(line_width_px, > 0, <= 100);
  LIMN_CHECK_RANGE(junction_radius_px, > 0, <= 100);
  LIMN_CHECK_RANGE(tolerance_px, >= 0.01, <= 10);
  LIMN_CHECK_RANGE(min_run_px, >= 0, <= 1000);
  LIMN_CHECK_RANGE(photo_opacity, >= 0, <= 1);
}

SvgSummary WriteDrawingSvg(const DrawingGraph& graph, const View& view, const IsHidden& is_hidden,
                           const SvgOptions& options, std::ostream& out) {
  options.Check();
  const std::string width = std::to_string(view.camera.width);
  const std::string height = std::to_string(view.camera.height);
  Picture picture;
  picture.size = "width=\"" + width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + ' ' +
                 height + '"';
  picture.description = "As seen in " + view.name + "; a unit is a pixel of the photograph.";
  picture.decimals = DecimalsFor(kRoundingPx);
  const LinkPathOptions path_options = PathOptions(options, picture.decimals);
  picture.draw_link = [&](const DrawingLink& link) {
    return DrawLink(view, link, is_hidden, path_options);
  };
  picture.place_of = [&](const Eigen::Vector3d& point) -> std::optional<Eigen::Vector2d> {
    const auto pixel = view.Project(point);
    const auto stored = pixel ? view.StoredFromVirtual(*pixel) : std::nullopt;
    if (!stored) return std::nullopt;
    return Eigen::Vector2d(stored->array() + 0.5);
  };
  if (!options.photo.empty()) {
    picture.background = [&](std::ostream& into) {
      into << "<image href=\"" << XmlEscaped(UrlPath(options.photo)) << "\" width=\"" << width
           << "\" height=\"" << height << "\" preserveAspectRatio=\"none\" opacity=\""
           << SvgNumber(options.photo_opacity, 3) << "\"/>\n";
    };
  }
  return SvgWriter(graph, picture, options, out).Write();
}

SvgSummary WriteDrawingSvg(const DrawingGraph& graph, const SvgSheet& sheet,
                           const IsHidden& is_hidden, const SvgOptions& options,
                           std::ostream& out) {
  options.Check();
  Picture picture;
  picture.px = sheet.px();
  picture.decimals = DecimalsFor(kRoundingPx * sheet.px());
  constexpr int kMmDecimals = 3;
  const auto number = [&](double value) { return SvgNumber(value, picture.decimals); };
  const Eigen::Vector2d extent = sheet.paper_max - sheet.paper_min;
  picture.size = "width=\"" + SvgNumber(sheet.PaperMm().x(), kMmDecimals) + "mm\" height=\"" +
                 SvgNumber(sheet.PaperMm().y(), kMmDecimals) + "mm\" viewBox=\"" +
                 number(sheet.paper_min.x()) + ' ' + number(sheet.paper_min.y()) + ' ' +
                 number(extent.x()) + ' ' + number(extent.y()) + '"';
  picture.description = SheetDescription(sheet);
  const LinkPathOptions path_options = PathOptions(options, picture.decimals);
  picture.draw_link = [&](const DrawingLink& link) {
    return DrawLink(sheet, link, is_hidden, path_options);
  };
  picture.place_of = [&](const Eigen::Vector3d& point) { return sheet.ToSheet(point); };
  if (sheet.has_legend) {
    picture.legend = [&](std::ostream& into) { WriteLegend(sheet, into); };
  }
  return SvgWriter(graph, picture, options, out).Write();
}

}  // namespace limn
