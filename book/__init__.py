"""The book: landing page, chapters, appendices, and the tools that build it."""
