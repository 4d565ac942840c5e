"""Profiles of cams as the bytes of files for drawings and machine tools."""
