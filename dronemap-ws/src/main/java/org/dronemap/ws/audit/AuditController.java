package org.dronemap.ws.audit;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletResponse;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import org.dronemap.core.audit.AuditQuery;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.FileMediaTypes;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.security.CurrentPrincipal;
import org.jspecify.annotations.Nullable;
import org.springdoc.core.annotations.ParameterObject;
import org.springframework.http.HttpHeaders;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.ModelAttribute;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers that search, export and verify the audit log. */
@RestController
@RequestMapping("/api/v1/audit")
@Tag(
        name = "Activity",
        description =
                "What was done, or asked for and refused, by whom, through which face. Every record stands for all"
                        + " before it, so that later changes show; for supervisors.")
class AuditController {
    private final AuditService audit;
    private final CurrentPrincipal current;
    private final JsonCodec json;

    AuditController(AuditService audit, CurrentPrincipal current, JsonCodec json) {
        this.audit = audit;
        this.current = current;
        this.json = json;
    }

    @GetMapping
    @Access(from = AccessLevel.SUPERVISOR, about = ResourceScope.ORGANISATION)
    @Operation(
            operationId = "searchAudit",
            summary = "Look for records (supervisor)",
            description = "Newest first, 50 unless limit says otherwise (1 to 200); go on with before = next. Times are"
                    + " as 2026-03-04T05:06:07Z.")
    public AuditService.AuditPage records(
            @ParameterObject @ModelAttribute AuditSearchRequest search,
            @RequestParam(required = false) @Nullable Long before,
            @RequestParam(required = false) @Nullable Integer limit) {
        return audit.page(current.principal(), search, before, limit);
    }

    @GetMapping("/file")
    @Access(from = AccessLevel.SUPERVISOR, about = ResourceScope.ORGANISATION, costs = RequestCost.EXPORT)
    @FileMediaTypes(produces = {"text/csv", "application/jsonl"})
    @Operation(
            operationId = "exportAudit",
            summary = "Take all that are looked for along as a file (supervisor)",
            description = "form: csv, or jsonl for a line of JSON each. Newest first.")
    public void file(
            @ParameterObject @ModelAttribute AuditSearchRequest search,
            @RequestParam(defaultValue = "csv") String form,
            HttpServletResponse response)
            throws IOException {
        AuditQuery query = audit.checked(current.principal(), search);
        AuditExportFormat file = AuditExportFormat.named(form);
        response.setContentType(file.mediaType() + ";charset=UTF-8");
        response.setHeader(HttpHeaders.CONTENT_DISPOSITION, "attachment; filename=\"" + file.fileName() + "\"");
        Writer out = new BufferedWriter(new OutputStreamWriter(response.getOutputStream(), StandardCharsets.UTF_8));
        file.begin(out);
        audit.export(query, record -> file.write(record, json, out));
        out.flush();
    }

    @GetMapping("/receipt")
    @Access(from = AccessLevel.SUPERVISOR, about = ResourceScope.SERVER)
    @Operation(
            operationId = "getAuditReceipt",
            summary = "Get a receipt for all records up to now (supervisor)",
            description =
                    "Kept outside of the server, it shows later whether any of them was changed or removed, even by"
                            + " whoever runs the server.")
    public ResponseEntity<AuditReceiptView> receipt() {
        return ResponseEntity.ok()
                .header(HttpHeaders.CONTENT_DISPOSITION, "attachment; filename=\"dronemap-receipt.json\"")
                .body(audit.receipt(current.principal()));
    }

    @PostMapping("/verification")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatuses(never = 409)
    @Operation(
            operationId = "verifyAudit",
            summary = "Verify all records, against a receipt too if one is sent (administrator)",
            description = "Names the first record that is not as it was.")
    public AuditService.VerdictView verify(@RequestBody(required = false) @Nullable AuditReceiptView receipt) {
        return audit.verify(current.principal(), receipt);
    }
}
