/* The files beside this one that stand in every page; the build makes strings of them. */
#pragma once

extern const char embedded_page_html[], embedded_page_css[], embedded_page_draw_js[],
    embedded_page_spheres_js[], embedded_page_panel_js[];
