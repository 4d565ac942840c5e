"""The chapter of the note on cams, a module a stage; `lexicon` holds what all of them call the same."""
