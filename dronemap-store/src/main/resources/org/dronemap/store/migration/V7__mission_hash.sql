-- Tells missions apart that differ only in settings of items which the cloud does not read.
ALTER TABLE known_mission ADD COLUMN content_hash text;
