package org.dronemap.ws.audit;

import io.swagger.v3.oas.annotations.media.Schema;
import java.io.IOException;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.audit.AuditHead;
import org.dronemap.core.audit.AuditHeadWriter;
import org.dronemap.core.audit.AuditQuery;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.audit.AuditVerdict;
import org.dronemap.core.audit.AuditedCallRecord;
import org.dronemap.core.audit.SignedAuditHead;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Searches, exports and verifies the audit log, for supervisors and administrators. Any thread. */
public final class AuditService {
    private static final int MOST_AT_ONCE = 200;
    private static final int USUALLY = 50;
    private static final int PAGE_OF_EXPORT = 1_000;

    private final AuditStore store;
    private final AuditHeadWriter heads;
    private final Verification verification;

    /** Compares all records with what is kept beside them, and with a receipt if there is one. */
    public interface Verification {
        AuditVerdict verify(@Nullable SignedAuditHead receipt);
    }

    /** Newest first; {@code next}: what to ask for as {@code before} to go on, null: that was all. */
    @Schema(name = "AuditPage")
    public record AuditPage(
            List<AuditView> records, @Nullable Long next) {}

    /** Result of an audit verification; {@code firstBad}: number of the first record that was altered or is missing. */
    @Schema(name = "AuditVerdictView")
    public record VerdictView(
            boolean sound, long records, @Nullable Long firstBad, String detail) {}

    /** Takes records one after the other. */
    public interface AuditSink {
        void accept(AuditView record) throws IOException;
    }

    public AuditService(AuditStore store, AuditHeadWriter heads, Verification verification) {
        this.store = store;
        this.heads = heads;
        this.verification = verification;
    }

    public AuditPage page(
            Principal principal, AuditSearchRequest search, @Nullable Long before, @Nullable Integer limit) {
        AuditQuery query = checked(principal, search);
        int most = limit == null ? USUALLY : limit;
        if (most < 1 || most > MOST_AT_ONCE) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "limit",
                    "1 to " + MOST_AT_ONCE,
                    most,
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(MOST_AT_ONCE));
        }
        List<AuditedCallRecord> lines = store.search(query, before == null ? Long.MAX_VALUE : before, most);
        Long next = lines.size() < most ? null : lines.get(most - 1).record().sequence();
        return new AuditPage(lines.stream().map(AuditView::of).toList(), next);
    }

    /** What somebody may look for: records of people of the own organisation; those who run the server see all. */
    public AuditQuery checked(Principal principal, AuditSearchRequest search) {
        RoleChecks.requireForAll(principal, Role.SUPERVISOR);
        boolean all = principal.organisation().isHome() && principal.may(Role.ADMINISTRATOR);
        return search.query(all ? null : principal.organisation().value());
    }

    /** All that fit, newest first, up to what was there when it began. */
    public void export(AuditQuery query, AuditSink to) throws IOException {
        long before = store.head().sequence() + 1;
        List<AuditedCallRecord> lines = store.search(query, before, PAGE_OF_EXPORT);
        while (!lines.isEmpty()) {
            for (AuditedCallRecord line : lines) {
                to.accept(AuditView.of(line));
            }
            before = lines.get(lines.size() - 1).record().sequence();
            lines = lines.size() < PAGE_OF_EXPORT ? List.of() : store.search(query, before, PAGE_OF_EXPORT);
        }
    }

    public AuditReceiptView receipt(Principal principal) {
        RoleChecks.requireServer(principal, Role.SUPERVISOR);
        if (store.head().equals(AuditHead.EMPTY)) {
            throw Rejection.of(
                    DroneProblem.NOTHING_RECORDED,
                    "Nothing has been recorded yet; there is nothing to give a receipt for.");
        }
        return AuditReceiptView.of(heads.receipt());
    }

    public VerdictView verify(Principal principal, @Nullable AuditReceiptView receipt) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        return view(verification.verify(receipt == null ? null : receipt.signedHead()));
    }

    private static VerdictView view(AuditVerdict verdict) {
        return new VerdictView(verdict.isSound(), verdict.head().sequence(), verdict.firstBad(), verdict.sentence());
    }
}
