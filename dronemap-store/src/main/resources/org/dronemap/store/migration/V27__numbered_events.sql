-- Events are numbered in the order in which they come to be seen, so that a program can go on after the last one it has read.

-- A database that was restored has numbered some twice; nobody has read these numbers yet.
DO $$
BEGIN
    IF EXISTS (SELECT FROM drone_event GROUP BY id HAVING count(*) > 1) THEN
        UPDATE drone_event SET id = ordered.number
        FROM (SELECT ctid AS place, row_number() OVER (ORDER BY at, id) AS number FROM drone_event) ordered
        WHERE drone_event.ctid = ordered.place;
    END IF;
END $$;

CREATE UNIQUE INDEX drone_event_number ON drone_event (id);

-- Where some events are missing, at a number of its own in the same series.
CREATE TABLE event_gap (
    number  bigint PRIMARY KEY,
    cause   text NOT NULL,
    -- Null: not known.
    from_at timestamptz,
    until_at timestamptz NOT NULL,
    -- How many; null: not known.
    lost    bigint
);

-- One row. It is in no backup: whatever is restored is another series.
CREATE TABLE event_series (
    id             text NOT NULL DEFAULT gen_random_uuid(),
    -- Since when a process stores events; null: none does, and the last one has stored all of them.
    opened_at      timestamptz,
    -- The highest number of what was dropped because its time was over; 0: nothing was.
    expired        bigint NOT NULL DEFAULT 0,
    -- What was dropped happened before that.
    expired_before timestamptz
);

CREATE UNIQUE INDEX event_series_one ON event_series ((true));
INSERT INTO event_series DEFAULT VALUES;

SELECT setval(pg_get_serial_sequence('drone_event', 'id'), number) FROM (SELECT max(id) AS number FROM drone_event) highest
WHERE number IS NOT NULL;
