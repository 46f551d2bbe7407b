"""What drawings are made of: shapes in the plane, ink and paper, and a panel for one moment."""
