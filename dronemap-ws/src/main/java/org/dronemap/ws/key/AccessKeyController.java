package org.dronemap.ws.key;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers that list, create, renew and delete the access keys with which a user's programs sign in. */
@RestController
@RequestMapping("/api/v1/access-keys")
@Tag(name = "Access keys", description = "One's own access keys, for programs.")
class AccessKeyController {
    private final AccessKeyService keys;
    private final CurrentPrincipal current;

    AccessKeyController(AccessKeyService keys, CurrentPrincipal current) {
        this.keys = keys;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.OWN)
    @Operation(operationId = "listAccessKeys", summary = "List one's own access keys")
    public AccessKeyService.Keys keys() {
        return new AccessKeyService.Keys(keys.keys(current.principal()));
    }

    @PostMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.OWN)
    @ResponseStatuses(201)
    @Operation(
            operationId = "makeAccessKey",
            summary = "Make an access key",
            description =
                    "The key itself is in this answer and never shown again. What is left out is as wide as you are;"
                            + " made with a key, it stays within that key and goes with it.")
    public ResponseEntity<AccessKeyView> addKey(@RequestBody AccessKeyRequest request) {
        AccessKeyView key = keys.addKey(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/access-keys/" + key.id()))
                .body(key);
    }

    @PostMapping("/{id}/renew")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.OWN)
    @ResponseStatuses(never = 409)
    @Operation(
            operationId = "renewAccessKey",
            summary = "Renew an access key",
            description = "The same key with a new secret, which is in this answer and never shown again; the old one"
                    + " is void at once. Keys made from it stay.")
    public AccessKeyView renew(@PathVariable String id) {
        return keys.renew(current.principal(), id);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.OWN)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "deleteAccessKey",
            summary = "Remove one of one's own access keys, with those made from it")
    public void deleteKey(@PathVariable String id) {
        keys.deleteKey(current.principal(), id);
    }
}
