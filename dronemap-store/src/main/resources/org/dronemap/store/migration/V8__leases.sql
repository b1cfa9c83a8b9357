-- Who has explicit control of a drone, and which epochs of control were ever handed out.

CREATE TABLE control_lease (
    drone_id     text PRIMARY KEY REFERENCES drone ON DELETE CASCADE,
    account_name text NOT NULL,
    since        timestamptz NOT NULL,
    epoch        bigint NOT NULL
);

CREATE TABLE control_epoch (
    only_row boolean PRIMARY KEY DEFAULT true CHECK (only_row),
    reserved bigint NOT NULL
);

INSERT INTO control_epoch (reserved) VALUES (0);

ALTER TABLE command ADD COLUMN epoch bigint;
