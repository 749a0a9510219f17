package org.jsmesh.desktop;

/** Width and height in pixels. */
record PictureSize(int width, int height) {}
