#include "bench/plot/svg.hpp"

#include <stdexcept>

#ifdef TAUTLINE_RSVG
#include <cairo.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>
#endif

namespace tautline::bench {

#ifdef TAUTLINE_RSVG

namespace {

struct Release {
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

cairo_status_t append(void* text, const unsigned char* data, unsigned size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);  // NOLINT
  return CAIRO_STATUS_SUCCESS;
}

/// Throws what went wrong.
void check(bool done, GError* error) {
  if (!done) {
    const std::string reason = error != nullptr ? error->message : "unknown reason";
    g_clear_error(&error);
    throw std::runtime_error("cannot make a PNG picture: " + reason);
  }
}

}  // namespace

bool makes_png() { return true; }

std::string png_of(const std::string& svg) {
  GError* error = nullptr;
  const auto* const data = reinterpret_cast<const guint8*>(svg.data());  // NOLINT
  const std::unique_ptr<RsvgHandle, Release> handle(
      rsvg_handle_new_from_data(data, svg.size(), &error));
  check(handle != nullptr, error);
  double width = 0.0;
  double height = 0.0;
  check(rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) != 0, nullptr);
  constexpr double scale = 2.0;  // sharp on paper and on a fine screen
  const RsvgRectangle sheet{0.0, 0.0, std::ceil(scale * width), std::ceil(scale * height)};
  const std::unique_ptr<cairo_surface_t, Release> surface(cairo_image_surface_create(
      CAIRO_FORMAT_ARGB32, static_cast<int>(sheet.width), static_cast<int>(sheet.height)));
  const std::unique_ptr<cairo_t, Release> context(cairo_create(surface.get()));
  check(rsvg_handle_render_document(handle.get(), context.get(), &sheet, &error) != 0, error);
  std::string result;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &result) == CAIRO_STATUS_SUCCESS,
        nullptr);
  return result;
}

#else

bool makes_png() { return false; }

std::string png_of(const std::string& /*svg*/) {
  throw std::runtime_error("this build makes no PNG pictures: it was made without librsvg");
}

#endif

}  // namespace tautline::bench
