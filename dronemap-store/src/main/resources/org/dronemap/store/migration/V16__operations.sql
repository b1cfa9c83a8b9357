-- What the cloud conducts with drones over time, and what it decided on what befell it: a state and the entry that made it
-- so are written together. The texts are understood by who conducts operations of that kind, and by nobody here.

CREATE TABLE operation (
    id           text COLLATE "C" PRIMARY KEY,
    kind         text NOT NULL,
    owner        text NOT NULL,
    organisation text,
    name         text NOT NULL,
    began_at     timestamptz NOT NULL,
    ended_at     timestamptz,
    last_entry   bigint NOT NULL,
    -- Drones and commands whose ends it was not told yet, in turn.
    given        text[] NOT NULL,
    state        text NOT NULL
);

CREATE INDEX operation_under_way ON operation (began_at, id) WHERE ended_at IS NULL;
CREATE INDEX operation_of_organisation ON operation (organisation, began_at DESC);

CREATE TABLE operation_journal (
    operation_id text COLLATE "C" NOT NULL REFERENCES operation ON DELETE CASCADE,
    number       bigint NOT NULL,
    at           timestamptz NOT NULL,
    input        text NOT NULL,
    decision     text NOT NULL,
    PRIMARY KEY (operation_id, number)
);
