package org.dronemap.ws.problem;

/** Problem codes of a missing sign-in, missing rights, and conflicts between accounts or organisations. */
public enum AccessProblem implements ProblemCode {
    SIGN_IN_NEEDED(ProblemCatalogueEntry.of(
            "sign-in-needed",
            RejectionKind.NOT_SIGNED_IN,
            "Nothing tells who asks.",
            "Sign in first, or send an access key.")),
    AUTHORIZATION_UNREADABLE(ProblemCatalogueEntry.of(
            "authorization-unreadable",
            RejectionKind.NOT_SIGNED_IN,
            "What tells who asks is written in a way that cannot be read.",
            "The Authorization header must be: Bearer, a space, and an access key.")),
    CREDENTIALS_WRONG(ProblemCatalogueEntry.of(
            "credentials-wrong",
            RejectionKind.NOT_SIGNED_IN,
            "Name or password is not right.",
            "The name or the password is not right.")),
    TOKEN_STALE(ProblemCatalogueEntry.of(
            "token-stale",
            RejectionKind.NOT_SIGNED_IN,
            "A UsernameToken says that it was made too long ago, or in the future.",
            "This UsernameToken was made more than 5 minutes from now by the server's clock; make a new one for each"
                    + " call.")),
    TOKEN_USED(ProblemCatalogueEntry.of(
            "token-used",
            RejectionKind.NOT_SIGNED_IN,
            "A UsernameToken was sent a second time.",
            "This UsernameToken was used before; make a new nonce for each call.")),
    ACCESS_KEY_WRONG(ProblemCatalogueEntry.of(
            "access-key-wrong",
            RejectionKind.NOT_SIGNED_IN,
            "The access key is none, or has ended.",
            "The access key is not valid; it may have been removed, renewed or expired.")),
    TICKET_SPENT(ProblemCatalogueEntry.of(
            "ticket-spent",
            RejectionKind.NOT_SIGNED_IN,
            "The ticket for a stream was used, or is too old.",
            "The ticket was used already or is older than 30 s; ask for a new one.")),
    PROVIDER_SIGN_IN_FAILED(ProblemCatalogueEntry.of(
                    "provider-sign-in-failed",
                    RejectionKind.NOT_SIGNED_IN,
                    "The other provider did not confirm who it is.",
                    "The sign-in with Example ID was not successful; try again.")
            .with(ProblemParameter.PROVIDER)),
    SESSION_ENDED(
            ProblemCatalogueEntry.of(
                    "session-ended",
                    RejectionKind.SESSION_ENDED,
                    "There was a session, which is no longer known.",
                    "This session has ended: after 12 hours, or because the account was changed or the stored data were restored. Sign in again.")),
    REQUEST_FORBIDDEN(ProblemCatalogueEntry.of(
            "request-forbidden",
            RejectionKind.FORBIDDEN,
            "The web server itself does not let the request through.",
            "Not allowed.")),
    SESSION_HEADER_MISSING(ProblemCatalogueEntry.of(
            "session-header-missing",
            RejectionKind.FORBIDDEN,
            "A change with a browser's session comes without the header that other sites cannot send.",
            "A change with a browser's session needs the header X-Dronemap: 1, which other sites cannot send.")),
    ORIGIN_FOREIGN(ProblemCatalogueEntry.of(
                    "origin-foreign",
                    RejectionKind.FORBIDDEN,
                    "A page of another host opens a stream.",
                    "The stream serves only pages of its own host, not of https://example.org.")
            .with(ProblemParameter.ORIGIN)),
    ACCOUNT_WAITS(ProblemCatalogueEntry.of(
            "account-waits",
            RejectionKind.FORBIDDEN,
            "The account was not let in yet.",
            "Your account waits until an administrator lets you in; try again later.")),
    ACCOUNT_DISABLED(ProblemCatalogueEntry.of(
            "account-disabled",
            RejectionKind.FORBIDDEN,
            "The account may not sign in any more.",
            "Your account has been disabled; ask an administrator.")),
    FIRST_PASSWORD_SEEN(
            ProblemCatalogueEntry.of(
                    "first-password-seen",
                    RejectionKind.FORBIDDEN,
                    "The server lets nobody in until its first password, which others may have seen, is changed.",
                    "This server is open to the network and still has its first administrator password; sign in as admin and change it, then everything works.")),
    PASSWORD_SEEN(ProblemCatalogueEntry.of(
            "password-seen",
            RejectionKind.FORBIDDEN,
            "The asker's password was seen by others and has to be changed first.",
            "Somebody else has seen your password; take one of your own first, then everything works.")),
    ROLE_CHANGED(ProblemCatalogueEntry.of(
            "role-changed",
            RejectionKind.FORBIDDEN,
            "The asker's rights were changed meanwhile.",
            "Your role was changed; connect again.")),
    ROLE_TOO_LOW(ProblemCatalogueEntry.of(
                    "role-too-low",
                    RejectionKind.FORBIDDEN,
                    "The asker's role may not do this.",
                    "Only an administrator may do this; you are signed in as operator.")
            .with(ProblemParameter.NEEDED, ProblemParameter.ROLE)),
    KEY_MAY_LESS(ProblemCatalogueEntry.of(
                    "key-may-less",
                    RejectionKind.FORBIDDEN,
                    "The access key is for other operations.",
                    "This access key may only observe; make one that may more.")
            .with(ProblemParameter.NEEDED)),
    KEY_LIMITED(ProblemCatalogueEntry.of(
            "key-limited",
            RejectionKind.FORBIDDEN,
            "An access key that may less than its user is not enough for this.",
            "A limited access key changes no password; sign in to do this.")),
    KEY_FOR_SOME_DRONES(ProblemCatalogueEntry.of(
            "key-for-some-drones",
            RejectionKind.FORBIDDEN,
            "The access key is for certain drones, and this concerns others.",
            "This access key is for certain drones only, and this concerns all of them.")),
    KEY_BOUNDED(ProblemCatalogueEntry.of(
            "key-bounded",
            RejectionKind.FORBIDDEN,
            "The access key has an area or heights, which this would not keep to.",
            "This access key has an area or heights, and what has none is closed to it.")),
    KEY_TOO_WIDE(ProblemCatalogueEntry.of(
                    "key-too-wide",
                    RejectionKind.FORBIDDEN,
                    "A key could do more than its owner, or than the key that it is made with.",
                    "A key made with this one cannot last longer than it.")
            .with(ProblemParameter.CLOSED_BY)),
    NOT_GRANTED(ProblemCatalogueEntry.of(
            "not-granted",
            RejectionKind.FORBIDDEN,
            "The role would do, but the asker was not granted this.",
            "You were not granted to do this; ask an administrator for a grant.")),
    SEES_NOT_ALL(ProblemCatalogueEntry.of(
            "sees-not-all",
            RejectionKind.FORBIDDEN,
            "The asker sees granted drones only, and this concerns all.",
            "You see only what you were granted, and this concerns all drones.")),
    SERVER_ONLY(ProblemCatalogueEntry.of(
            "server-only",
            RejectionKind.FORBIDDEN,
            "This concerns the whole server, and is for those who run it.",
            "This concerns the whole server; ask those who run it.")),
    OWNER_ONLY(ProblemCatalogueEntry.of(
                    "owner-only",
                    RejectionKind.FORBIDDEN,
                    "It belongs to another user.",
                    "Only mia says where the phone is.")
            .with(ProblemParameter.OWNER)),
    NO_OWN_ACCOUNT(ProblemCatalogueEntry.of(
            "no-own-account",
            RejectionKind.FORBIDDEN,
            "Who asks is no user with a password and keys.",
            "Only a user can own access keys; sign in as one.")),
    REGISTRATION_CLOSED(ProblemCatalogueEntry.of(
            "registration-closed",
            RejectionKind.FORBIDDEN,
            "Nobody makes an own account here.",
            "Accounts are made by the administrators of this server; ask one.")),
    INVITATION_NEEDED(
            ProblemCatalogueEntry.of(
                    "invitation-needed",
                    RejectionKind.FORBIDDEN,
                    "Only who was invited makes an own account here.",
                    "Only those who were invited can make an account here; open the link of your invitation, or ask an administrator for one.")),
    NO_OTHER_PROVIDER(ProblemCatalogueEntry.of(
            "no-other-provider",
            RejectionKind.UNKNOWN,
            "The server signs in by name and password only.",
            "There is no other provider to sign in with; sign in by name and password.")),
    NOT_TO_ONESELF(ProblemCatalogueEntry.of(
            "not-to-oneself",
            RejectionKind.CONFLICT,
            "Nobody may take the own rights away.",
            "You cannot do this to yourself; ask another administrator.")),
    NAME_TAKEN(ProblemCatalogueEntry.of(
                    "name-taken",
                    RejectionKind.CONFLICT,
                    "Another user or organisation has this name, or one that looks like it.",
                    "The name mia is taken, or looks like one that is; choose another one.")
            .with(ProblemParameter.NAME)),
    PASSPHRASE_UNUSABLE(ProblemCatalogueEntry.of(
            "passphrase-unusable",
            RejectionKind.CONFLICT,
            "The passphrase would open another user's door.",
            "This passphrase cannot be used; take another one.")),
    ORGANISATION_NOT_EMPTY(ProblemCatalogueEntry.of(
                    "organisation-not-empty",
                    RejectionKind.CONFLICT,
                    "Only an organisation without users and drones is removed.",
                    "Hill Survey still has 2 users and 1 drones; only an empty organisation can be removed.")
            .with(ProblemParameter.USERS, ProblemParameter.DRONES));

    @SuppressWarnings("ImmutableEnumChecker") // its lists never change
    private final ProblemCatalogueEntry entry;

    AccessProblem(ProblemCatalogueEntry entry) {
        this.entry = entry;
    }

    @Override
    public ProblemCatalogueEntry entry() {
        return entry;
    }
}
