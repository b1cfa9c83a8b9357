-- The areas and heights that flights commanded with a key stay within, the widest first; null: none.

ALTER TABLE access_key ADD COLUMN bounds json;
