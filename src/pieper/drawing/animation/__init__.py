"""A motion as a moving picture: GIF, WebP, MP4, or a page that plays it."""
