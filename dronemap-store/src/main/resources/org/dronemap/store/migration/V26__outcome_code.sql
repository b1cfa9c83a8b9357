-- Why a command was refused, as a word for programs; null: an earlier version wrote the outcome.
ALTER TABLE command ADD COLUMN outcome_code text;
