// What the programs of the figures share: pictures side by side in one file, and with --pages a page of each.
#pragma once

#include <concino/render.hpp>

#include <string>
#include <vector>

/// A figure by the arguments of its program:  picture.png [width [surface.obj]] [--pages]
class figure {
  std::vector<std::string> arguments_;
  std::size_t columns_;
  double height_;
  bool pages_;
  std::vector<concino::image> pictures_;
  std::vector<std::string> captions_;

 public:
  /// height: of a picture, in its widths.
  figure(int argc, char** argv, std::size_t columns, double height = 0.75)
      : arguments_(argv + 1, argv + argc), columns_(columns), height_(height), pages_(std::erase(arguments_, "--pages") > 0) {}

  std::size_t width() const { return arguments_.size() > 1 ? std::stoul(arguments_[1]) : 1200; }
  /// The file of a surface; empty if none is given.
  std::string surface() const { return arguments_.size() > 2 ? arguments_[2] : ""; }

  /// Draws a scene and, if asked to, writes its page, such as picture_1.html.
  void add(const concino::scene& s, const std::string& caption, concino::render_options options = {}) {
    options.width = width() / columns_;
    options.height = static_cast<std::size_t>(static_cast<double>(options.width) * height_);
    pictures_.push_back(concino::render(s, options));
    captions_.push_back(caption);
    if (!pages_ || arguments_.empty()) return;
    const std::string stem = arguments_[0].substr(0, arguments_[0].rfind('.'));
    concino::save_html(s, stem + "_" + std::to_string(pictures_.size()) + ".html", {.title = caption, .camera = options.camera, .up = options.up});
  }

  void save() const {
    if (!arguments_.empty()) concino::save_png(concino::make_sheet(pictures_, {.columns = columns_, .captions = captions_}), arguments_[0]);
  }
};
