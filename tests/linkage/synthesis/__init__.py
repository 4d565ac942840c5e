"""Tests of the synthesis of linkages."""
