-- Drones, what is known to be on them, saved missions, the log of commands, and who may sign in.

CREATE TABLE drone (
    id           text PRIMARY KEY,
    name         text NOT NULL,
    address      text NOT NULL,
    port         integer NOT NULL,
    system_id    integer NOT NULL,
    transport    text NOT NULL,
    kind         text NOT NULL,
    autopilot    text NOT NULL,
    vehicle      text NOT NULL,
    firmware     text,
    hardware_uid text,
    last_heard   timestamptz NOT NULL
);

-- Items are json, not jsonb: numbers come back exactly as they were written.
CREATE TABLE known_mission (
    drone_id     text PRIMARY KEY REFERENCES drone ON DELETE CASCADE,
    items        json NOT NULL,
    current_item integer
);

CREATE TABLE saved_mission (
    id         text PRIMARY KEY,
    name       text NOT NULL,
    items      json NOT NULL,
    changed_by text NOT NULL,
    changed_at timestamptz NOT NULL
);

-- No reference to drone: the log outlives the drones that it speaks of.
CREATE TABLE command (
    id             text PRIMARY KEY,
    drone_id       text NOT NULL,
    asked_by       text NOT NULL,
    face           text NOT NULL,
    type           text NOT NULL,
    summary        text NOT NULL,
    asked_at       timestamptz NOT NULL,
    phase          text NOT NULL CHECK (phase IN ('SENT', 'ACCEPTED', 'DONE')),
    progress_done  integer,
    progress_total integer,
    outcome        text CHECK (outcome IN ('SUCCEEDED', 'REFUSED', 'FAILED', 'TIMED_OUT', 'SUPERSEDED', 'UNKNOWN')),
    outcome_by     text,
    outcome_reason text,
    finished_at    timestamptz,
    CHECK ((phase = 'DONE') = (outcome IS NOT NULL)),
    CHECK ((phase = 'DONE') = (finished_at IS NOT NULL))
);

CREATE INDEX command_of_drone ON command (drone_id, asked_at DESC);
CREATE INDEX command_unfinished ON command (id) WHERE phase <> 'DONE';

CREATE TABLE account (
    name                 text PRIMARY KEY,
    role                 text NOT NULL CHECK (role IN ('VIEWER', 'OPERATOR', 'ADMINISTRATOR')),
    password_hash        text NOT NULL,
    must_change_password boolean NOT NULL
);

CREATE TABLE sign_in (
    token_hash   text PRIMARY KEY,
    account_name text NOT NULL REFERENCES account ON DELETE CASCADE,
    expires_at   timestamptz NOT NULL
);

CREATE INDEX sign_in_of_account ON sign_in (account_name);

CREATE TABLE access_key (
    id           text PRIMARY KEY,
    label        text NOT NULL,
    account_name text NOT NULL REFERENCES account ON DELETE CASCADE,
    role         text NOT NULL CHECK (role IN ('VIEWER', 'OPERATOR', 'ADMINISTRATOR')),
    secret_hash  text NOT NULL UNIQUE,
    created_at   timestamptz NOT NULL
);

CREATE INDEX access_key_of_account ON access_key (account_name);
