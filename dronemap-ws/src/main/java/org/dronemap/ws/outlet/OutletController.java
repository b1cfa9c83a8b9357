package org.dronemap.ws.outlet;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.security.CurrentPrincipal;
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
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers by which users attach their own ground stations to the outlet: passphrases, ports and clients. */
@RestController
@RequestMapping("/api/v1/outlet")
@Tag(name = "Outlet", description = "Attach QGroundControl, Mission Planner, MAVProxy or a program of one's own.")
class OutletController {
    private final OutletService outlet;
    private final CurrentPrincipal current;

    OutletController(OutletService outlet, CurrentPrincipal current) {
        this.outlet = outlet;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.OWN)
    @Operation(
            operationId = "getOutlet",
            summary = "Where to attach, whether a passphrase is set, and one's own programs that are attached")
    public OutletService.OwnOutletView own() {
        return outlet.own(current.principal());
    }

    @PutMapping("/passphrase")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.OWN)
    @Operation(
            operationId = "setOutletPassphrase",
            summary = "Set one's own signing passphrase",
            description = "Without one given it is made up. It is in this answer and never shown again; programs that"
                    + " use the one before are disconnected.")
    public ResponseEntity<OutletService.PassphraseView> set(@RequestBody OutletService.PassphraseRequest request) {
        return ResponseEntity.ok()
                .cacheControl(CacheControl.noStore())
                .body(outlet.setPassphrase(current.principal(), request));
    }

    @DeleteMapping("/passphrase")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.OWN)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "clearOutletPassphrase",
            summary = "Take one's own signing passphrase away",
            description = "Programs that use it are disconnected.")
    public void clear() {
        outlet.clearPassphrase(current.principal());
    }

    @PostMapping("/ports")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.OWN)
    @ResponseStatus(HttpStatus.CREATED)
    @Operation(
            operationId = "openOutletPort",
            summary = "Open a personal port, view-only, for a program that cannot sign",
            description = "The first to speak there from that address or network has it, until it is closed, its hours"
                    + " are over or the server is restarted. It shows unsigned what you may see; nothing sent there"
                    + " changes anything.")
    public OutletView.PortView openPort(@RequestBody OutletService.PortRequest request) {
        return outlet.openPort(current.principal(), request);
    }

    @DeleteMapping("/ports/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.OWN)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "closeOutletPort",
            summary = "Close a personal port of one's own, or as an administrator anybody's")
    public void closePort(@PathVariable String id) {
        outlet.closePort(current.principal(), id);
    }

    @GetMapping("/clients")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(
            operationId = "listOutletClients",
            summary = "List all that is attached, and what was refused (administrator)")
    public OutletView clients() {
        return outlet.all(current.principal());
    }

    @DeleteMapping("/clients/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "disconnectOutletClient",
            summary = "Disconnect what is attached (administrator)",
            description = "It may attach again after a minute; taking the passphrase away, or disabling the user, is"
                    + " what keeps it out.")
    public void disconnect(@PathVariable String id) {
        outlet.disconnect(current.principal(), id);
    }
}
