"""What MkDocs calls while it builds the site; it finds this file by its path."""

from dronemap_site.build import on_files, on_post_build, on_post_page

__all__ = ["on_files", "on_post_build", "on_post_page"]
