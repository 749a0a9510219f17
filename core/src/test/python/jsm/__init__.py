"""A decoder of .jsm archives, written along docs/format.md."""
