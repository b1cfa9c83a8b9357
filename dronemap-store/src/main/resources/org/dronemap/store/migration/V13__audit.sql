-- What was done by whom. Rows are only ever added; each is chained to the one before by its hash.

CREATE TABLE audit (
    sequence       bigint PRIMARY KEY,
    happened_at    timestamptz NOT NULL,
    account_name   text,
    -- Of the account; null: the server's own matter. No reference: records outlive what they name.
    organisation_id text,
    access_key     text,
    face           text NOT NULL,
    operation      text NOT NULL,
    drone_id       text,
    epoch          bigint,
    command_id     text,
    parameters     text NOT NULL,
    outcome        text NOT NULL,
    reason         text,
    latency_millis bigint,
    -- The row that this one tells the end of; null: it is the record of a call itself.
    ends           bigint,
    hash           text NOT NULL
);

CREATE INDEX audit_of_account ON audit (account_name, sequence DESC);
CREATE INDEX audit_of_drone ON audit (drone_id, sequence DESC) WHERE drone_id IS NOT NULL;
CREATE INDEX audit_of_time ON audit (happened_at);
CREATE INDEX audit_of_command ON audit (command_id) WHERE command_id IS NOT NULL AND ends IS NULL;
CREATE UNIQUE INDEX audit_ending ON audit (ends) WHERE ends IS NOT NULL;
CREATE INDEX audit_under_way ON audit (sequence) WHERE outcome = 'UNDER_WAY';
