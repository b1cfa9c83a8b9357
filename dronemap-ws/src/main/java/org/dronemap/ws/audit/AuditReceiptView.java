package org.dronemap.ws.audit;

import com.fasterxml.jackson.annotation.JsonProperty;
import io.swagger.v3.oas.annotations.media.Schema;
import java.time.DateTimeException;
import java.time.Instant;
import org.dronemap.core.audit.AuditHead;
import org.dronemap.core.audit.SignedAuditHead;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Signed receipt by which a client can prove later that the audit log up to one record has not been changed. */
@Schema(name = "ReceiptView", description = "Keep it where nobody who runs the server can change it.")
public record AuditReceiptView(
        @JsonProperty("sequence") @Nullable Long sequence,
        @JsonProperty("hash") @Nullable String hash,
        @JsonProperty("at") @Nullable String at,
        @JsonProperty("signature") @Nullable String signature) {
    static AuditReceiptView of(SignedAuditHead signed) {
        return new AuditReceiptView(
                signed.head().sequence(), signed.head().hash(), signed.at().toString(), signed.signature());
    }

    /** As it was signed, unless somebody changed it. */
    public SignedAuditHead signedHead() {
        return new SignedAuditHead(
                SignedAuditHead.Kind.ANCHORED,
                new AuditHead(sequence == null ? missingNumber() : sequence, given("hash", hash)),
                time(given("at", at)),
                given("signature", signature));
    }

    private static long missingNumber() {
        throw InvalidInput.missing("sequence", "a number as the receipt has it");
    }

    private static String given(String field, @Nullable String value) {
        if (value == null) {
            throw InvalidInput.missing(field, "as the receipt has it");
        }
        return value;
    }

    private static Instant time(String text) {
        try {
            return Instant.parse(text);
        } catch (DateTimeException e) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_MALFORMED, "at", "a time as the receipt has it", "\"" + text + "\"");
        }
    }
}
