-- More roles, users who wait or are shut out, and invitations.

ALTER TABLE account
    DROP CONSTRAINT account_role_check,
    ADD CONSTRAINT account_role_check
        CHECK (role IN ('REPORTER', 'VIEWER', 'PLANNER', 'OPERATOR', 'SUPERVISOR', 'ADMINISTRATOR')),
    ADD COLUMN state text NOT NULL DEFAULT 'ACTIVE' CHECK (state IN ('WAITING', 'ACTIVE', 'DISABLED'));

-- Those who were there stay in; nobody gets in later by being left out.
ALTER TABLE account ALTER COLUMN state DROP DEFAULT;

ALTER TABLE access_key
    DROP CONSTRAINT access_key_role_check,
    ADD CONSTRAINT access_key_role_check
        CHECK (role IN ('REPORTER', 'VIEWER', 'PLANNER', 'OPERATOR', 'SUPERVISOR', 'ADMINISTRATOR'));

CREATE TABLE invitation (
    id         text PRIMARY KEY,
    label      text NOT NULL,
    role       text NOT NULL
        CHECK (role IN ('REPORTER', 'VIEWER', 'PLANNER', 'OPERATOR', 'SUPERVISOR', 'ADMINISTRATOR')),
    code_hash  text NOT NULL UNIQUE,
    invited_by text NOT NULL,
    expires_at timestamptz NOT NULL
);
