-- By how much messages of a vehicle come sooner or later than those before them, in ms over some 5 s and 60 s; null where
-- that is not known, as in all states before this column was there.
ALTER TABLE telemetry ADD COLUMN jitter real;
ALTER TABLE telemetry ADD COLUMN jitter_long real;
