-- Organisations that never see each other, and who may do what with which drones.
-- No organisation (null): the default one, to which belongs all that was there.

CREATE TABLE organisation (
    id      text PRIMARY KEY,
    name    text NOT NULL,
    made_at timestamptz NOT NULL
);

ALTER TABLE account ADD COLUMN organisation text REFERENCES organisation;
ALTER TABLE invitation ADD COLUMN organisation text REFERENCES organisation ON DELETE CASCADE;
ALTER TABLE saved_mission ADD COLUMN organisation text REFERENCES organisation ON DELETE CASCADE;

-- No reference at all: it outlives the drone, whose recordings and commands stay, and the organisation, whose drones then are nobody's.
CREATE TABLE drone_owner (
    drone_id     text PRIMARY KEY,
    organisation text NOT NULL
);

CREATE TABLE user_group (
    id           text PRIMARY KEY,
    organisation text REFERENCES organisation ON DELETE CASCADE,
    name         text NOT NULL
);

CREATE TABLE user_group_member (
    group_id     text NOT NULL REFERENCES user_group ON DELETE CASCADE,
    account_name text NOT NULL REFERENCES account ON DELETE CASCADE,
    PRIMARY KEY (group_id, account_name)
);

CREATE INDEX user_group_member_by_account ON user_group_member (account_name);

-- The ids of the drones, separated by commas.
CREATE TABLE fleet (
    id           text PRIMARY KEY,
    organisation text REFERENCES organisation ON DELETE CASCADE,
    name         text NOT NULL,
    drones       text NOT NULL
);

-- For one user or one group; of one fleet, of some drones (their ids, separated by commas), or of all (neither).
CREATE TABLE access_grant (
    id           text PRIMARY KEY,
    organisation text REFERENCES organisation ON DELETE CASCADE,
    account_name text REFERENCES account ON DELETE CASCADE,
    group_id     text REFERENCES user_group ON DELETE CASCADE,
    fleet_id     text REFERENCES fleet ON DELETE CASCADE,
    drones       text,
    permissions  text NOT NULL,
    begins_at    timestamptz NOT NULL,
    ends_at      timestamptz,
    made_by      text NOT NULL,
    made_at      timestamptz NOT NULL,
    CHECK ((account_name IS NULL) <> (group_id IS NULL)),
    CHECK (fleet_id IS NULL OR drones IS NULL)
);

-- Those who see nothing but what they were granted.
CREATE TABLE only_granted (
    account_name text UNIQUE REFERENCES account ON DELETE CASCADE,
    group_id     text UNIQUE REFERENCES user_group ON DELETE CASCADE,
    CHECK ((account_name IS NULL) <> (group_id IS NULL))
);
