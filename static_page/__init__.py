"""The page without a server: built by `python -m static_page.build`, or `make site`."""
