-- A digest (SHA-256, hexadecimal) of what was asked for, which tells the same command from another under its id; null: written before.

ALTER TABLE command ADD COLUMN content text;
