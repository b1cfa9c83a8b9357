package org.dronemap.ws.link;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.jspecify.annotations.Nullable;
import org.springframework.http.CacheControl;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers for MAVLink signing of a drone: its signing key, and whether its messages must be signed. */
@RestController
@RequestMapping("/api/v1/drones/{id}")
@Tag(name = "Signed links", description = "Keys of vehicles, and whether their messages must be signed.")
class LinkSecurityController {
    private final LinkSecurityService links;
    private final CurrentPrincipal current;

    LinkSecurityController(LinkSecurityService links, CurrentPrincipal current) {
        this.links = links;
        this.current = current;
    }

    @GetMapping("/link-security")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(operationId = "getLinkSecurity", summary = "Look at how a drone's link is secured, and what was refused")
    public LinkSecurityView look(@PathVariable String id) {
        return links.look(current.principal(), id);
    }

    @PutMapping("/link-security")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.DRONE)
    @Operation(operationId = "setLinkSecurity", summary = "Set the policy: off, optional or required (administrator)")
    public LinkSecurityView policy(@PathVariable String id, @RequestBody LinkSecurityService.PolicyRequest request) {
        return links.setPolicy(current.principal(), id, request);
    }

    @PostMapping("/link-key")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.DRONE)
    @ResponseStatuses(201)
    @Operation(
            operationId = "makeLinkKey",
            summary = "Make a key, or bring one along (administrator)",
            description = "The key is in this answer and never shown again; it is not on the vehicle yet.")
    public ResponseEntity<LinkSecurityService.MadeKey> make(
            @PathVariable String id, @RequestBody LinkSecurityService.LinkKeyRequest request) {
        LinkSecurityService.MadeKey made = links.makeKey(current.principal(), id, request);
        return ResponseEntity.status(HttpStatus.CREATED)
                .cacheControl(CacheControl.noStore())
                .body(made);
    }

    @PostMapping("/link-key/install")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.DRONE)
    @ResponseStatuses({200, 202})
    @Operation(
            operationId = "installLinkKey",
            summary = "Give the vehicle its key and hear that it signs (administrator)",
            description = "Over a safe link only, unless confirmed. 202: still under way.")
    public ResponseEntity<LinkSecurityView> install(
            @PathVariable String id,
            @RequestBody(required = false) LinkSecurityService.@Nullable ChangeRequest request) {
        return answer(links.install(current.principal(), id, request));
    }

    @PostMapping("/link-key/rotate")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.DRONE)
    @ResponseStatuses({200, 202})
    @Operation(
            operationId = "rotateLinkKey",
            summary = "Change the vehicle over to a new key (administrator)",
            description = "Both keys are accepted meanwhile; on failure the old one stays. 202: still under way.")
    public ResponseEntity<LinkSecurityView> rotate(
            @PathVariable String id,
            @RequestBody(required = false) LinkSecurityService.@Nullable ChangeRequest request) {
        return answer(links.rotate(current.principal(), id, request));
    }

    @DeleteMapping("/link-key")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.DRONE)
    @ResponseStatuses(
            value = {200, 202},
            refuses = 409)
    @Operation(
            operationId = "deleteLinkKey",
            summary = "Take the key off the vehicle (administrator)",
            description = "With vehicle=false it is forgotten here only. The policy becomes off. 202: still under way.")
    public ResponseEntity<LinkSecurityView> revoke(
            @PathVariable String id, @RequestParam(defaultValue = "true") boolean vehicle) {
        return answer(links.revoke(current.principal(), id, vehicle));
    }

    private static ResponseEntity<LinkSecurityView> answer(LinkSecurityView view) {
        return ResponseEntity.status(view.changing() == null ? HttpStatus.OK : HttpStatus.ACCEPTED)
                .body(view);
    }
}
