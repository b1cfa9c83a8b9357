-- How far access keys reach, until when, what they were made from, and when they were last used.

ALTER TABLE access_key
    -- The ids, separated by commas; null: all drones.
    ADD COLUMN drones       text,
    ADD COLUMN permissions  text NOT NULL DEFAULT 'VIEW,PLAN,COMMAND,ADMINISTER',
    ADD COLUMN expires_at   timestamptz,
    ADD COLUMN parent       text REFERENCES access_key ON DELETE CASCADE,
    ADD COLUMN last_used_at timestamptz;

-- Keys that were there stay as they are; none gets wider later by being left out.
ALTER TABLE access_key ALTER COLUMN permissions DROP DEFAULT;

CREATE INDEX access_key_of_parent ON access_key (parent);
