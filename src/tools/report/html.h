// SPDX-License-Identifier: MIT
// Pages for people: one file each, pictures and all, that asks nothing of the network (and says so to the
// browser).
//
//   std::string body = report::figure("A", report::picture("a", before)) +
//                      report::figure("B", report::picture("b", after)) + report::slider("a", "b", "A", "B");
//   write_text("page.html", report::page("before and after", body));
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.h"

namespace dermis::report {

/// "data:image/png;base64,..."; alpha is left out.
std::string png_uri(const image::Image8& picture);

/// An img element. id: a name of its own on the page, which slider() refers to. Pictures keep their size up
/// to the width of the window.
std::string picture(std::string_view id, const image::Image8& pixels, std::string_view alt = {});

/// A block with a caption below it; figures stand side by side while there is room. caption and inner are
/// HTML: escape() what is text.
std::string figure(std::string_view caption, std::string_view inner);

/// Two pictures of one size over each other, named by their ids; the pointer or the arrow keys move the
/// border between them. The pixels are those of the other elements: they are in the file once.
std::string slider(std::string_view left_id, std::string_view right_id, std::string_view left_label,
                   std::string_view right_label);

/// The colours of image::error_colours from 0 to full_scale, with numbers.
std::string magma_scale(double full_scale);

/// Rows of text in two columns; escaped here.
std::string table(const std::vector<std::pair<std::string, std::string>>& rows);

/// A table with a row of headings; text, escaped here. All but the first column are set to the right.
std::string grid(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows);

/// The whole document. title is text, body is HTML.
std::string page(std::string_view title, std::string_view body);

}  // namespace dermis::report
