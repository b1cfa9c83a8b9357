package org.dronemap.ws.robotkey;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.CacheControl;
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

/** REST handlers that issue, list and revoke the keys with which ROSLink robots prove who they are. */
@RestController
@RequestMapping("/api/v1/robot-keys")
@Tag(name = "Robot keys", description = "By which robots are known, each as a drone of its organisation.")
class RobotKeyController {
    private final RobotKeyService keys;
    private final CurrentPrincipal current;

    /** All of them. */
    @Schema(name = "RobotKeys")
    public record RobotKeys(List<RobotKeyService.RobotKeyView> robotKeys) {}

    RobotKeyController(RobotKeyService keys, CurrentPrincipal current) {
        this.keys = keys;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @Operation(operationId = "listRobotKeys", summary = "List the keys of robots (administrator)")
    public RobotKeys robotKeys() {
        return new RobotKeys(keys.keys(current.principal()));
    }

    @PostMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(value = 201, refuses = 404)
    @Operation(
            operationId = "issueRobotKey",
            summary = "Issue the key of a robot (administrator)",
            description =
                    "The key is in this answer and never shown again. With \"drone\" it replaces that robot's key,"
                            + " and the one before is void at once.")
    public ResponseEntity<RobotKeyService.RobotKeyView> issue(@RequestBody RobotKeyService.RobotKeyRequest request) {
        RobotKeyService.RobotKeyView key = keys.issue(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/robot-keys/" + key.id()))
                .cacheControl(CacheControl.noStore())
                .body(key);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "revokeRobotKey",
            summary = "Revoke the key of a robot (administrator)",
            description = "Its links end at once. Its drone stays, with all that is known of it.")
    public void revoke(@PathVariable String id) {
        keys.revoke(current.principal(), id);
    }
}
