package org.dronemap.ws.problem;

/** Problem codes of malformed requests, whatever they ask for. */
public enum RequestProblem implements ProblemCode {
    REQUEST_UNREADABLE(ProblemCatalogueEntry.of(
            "request-unreadable",
            RejectionKind.MALFORMED,
            "The request as such, such as a header, cannot be read.",
            "The request cannot be understood.")),
    ADDRESS_NOT_PLAIN(
            ProblemCatalogueEntry.of(
                    "address-not-plain",
                    RejectionKind.MALFORMED,
                    "The address has empty or dotted parts, a semicolon, or an escape that it does not need.",
                    "The address must be written plainly: without empty, '.' or '..' parts, without ';', and with '%' only for what cannot stand in an address otherwise.")),
    BODY_NOT_AN_OBJECT(ProblemCatalogueEntry.of(
            "body-not-an-object",
            RejectionKind.MALFORMED,
            "The body or message is missing, or is JSON that is no object.",
            "A JSON object is needed as the body of this request.")),
    JSON_UNREADABLE(ProblemCatalogueEntry.of(
                    "json-unreadable",
                    RejectionKind.MALFORMED,
                    "The body or message is not JSON.",
                    "This is not JSON: line 1, column 9: Unexpected end-of-input.")
            .with(ProblemParameter.LINE, ProblemParameter.COLUMN)),
    XML_UNREADABLE(ProblemCatalogueEntry.of(
            "xml-unreadable",
            RejectionKind.MALFORMED,
            "The envelope is not XML that can be read.",
            "The XML cannot be read.")),
    KML_UNREADABLE(ProblemCatalogueEntry.of(
                    "kml-unreadable",
                    RejectionKind.MALFORMED,
                    "The body is not KML that can be read.",
                    "This is not KML.")
            .maybe(ProblemParameter.LINE, ProblemParameter.COLUMN)),
    ADDRESS_UNKNOWN(ProblemCatalogueEntry.of(
                    "address-unknown",
                    RejectionKind.UNKNOWN,
                    "There is nothing at this address.",
                    "There is nothing at /api/v1/drone; /api/docs lists the addresses.")
            .maybe(ProblemParameter.ADDRESS)),
    OPERATION_UNKNOWN(ProblemCatalogueEntry.of(
            "operation-unknown",
            RejectionKind.UNKNOWN,
            "The service of SOAP has no operation of this name.",
            "FollowerService has no operation land; its description lists them.")),
    METHOD_NOT_TAKEN(ProblemCatalogueEntry.of(
                    "method-not-taken",
                    RejectionKind.METHOD,
                    "The address does not take this method of HTTP.",
                    "This address does not take PUT; it takes GET.")
            .maybe(ProblemParameter.METHOD, ProblemParameter.ALLOWED)),
    BODY_TOO_SLOW(ProblemCatalogueEntry.of(
            "body-too-slow",
            RejectionKind.TOO_SLOW,
            "The request came too slowly.",
            "The body of this request came too slowly; send it again.")),
    BODY_TOO_LARGE(ProblemCatalogueEntry.of(
                    "body-too-large",
                    RejectionKind.TOO_LARGE,
                    "The body has more bytes than are taken here.",
                    "The body of this request may have at most 64 kB.")
            .maybe(ProblemParameter.MOST, ProblemParameter.UNIT)),
    ANSWER_TOO_LARGE(ProblemCatalogueEntry.of(
            "answer-too-large",
            RejectionKind.TOO_LARGE,
            "The answer has more bytes than a message of SOAP may have.",
            "This answer is longer than a SOAP message may be, 4194304 bytes; get it by GET"
                    + " /api/v1/recordings/{id}/file with the same key, or ask for less.")),
    CONTENT_TYPE_NOT_TAKEN(ProblemCatalogueEntry.of(
                    "content-type-not-taken",
                    RejectionKind.MEDIA_TYPE,
                    "The body is of a kind that the address does not take.",
                    "The body must be application/json; say so in Content-Type.")
            .maybe(ProblemParameter.ALLOWED)),
    ANSWER_TYPE_NOT_SERVED(ProblemCatalogueEntry.of(
            "answer-type-not-served",
            RejectionKind.MEDIA_TYPE,
            "The Accept header rules out what the address answers with.",
            "The answer is JSON; the Accept header rules that out."));

    @SuppressWarnings("ImmutableEnumChecker") // its lists never change
    private final ProblemCatalogueEntry entry;

    RequestProblem(ProblemCatalogueEntry entry) {
        this.entry = entry;
    }

    @Override
    public ProblemCatalogueEntry entry() {
        return entry;
    }
}
